; The force is finite, whatever the viscous and the damping term and dt are.
(set-logic QF_FP)
(define-sort F () Float32)
(define-fun zero () F (_ +zero 8 24))
(define-fun is_finite ((x F)) Bool (not (or (fp.isNaN x) (fp.isInfinite x))))

; TERM_MAX, FLT_MAX/4; 2^-10
(define-fun term_max () F (fp #b0 #xfc #b11111111111111111111111))
(define-fun share () F (fp #b0 #x75 #b00000000000000000000000))

(define-fun limited ((x F)) F
  (ite (fp.isNaN x) zero
    (ite (fp.gt x term_max) term_max
      (ite (fp.lt x (fp.neg term_max)) (fp.neg term_max) x))))

; guarded_force() with s = 1; that all of it is odd, is tested
(define-fun guarded ((others F) (force F)) F
  (let ((least (fp.mul RNE others share))) (ite (fp.lt force least) least force)))

; are_usable()
(define-fun usable ((force F) (dt F)) Bool
  (let ((sum (fp.add RNE (fp.abs force) dt))) (fp.gt dt (fp.sub RNE sum sum))))

; the terms: elastic, viscous, damped as the common way has it, and as unusual_force() makes it again
(declare-const elastic F)
(declare-const viscous F)
(declare-const damped F)
(declare-const damped_again F)
(declare-const dt F)
(declare-const case_1 Bool)

(define-fun force () F
  (let ((others (fp.add RNE elastic viscous)))
    (let ((sum (fp.add RNE others damped)))
      (ite (usable sum dt) (ite case_1 (guarded others sum) sum)
        (let ((others_again (fp.add RNE elastic (limited viscous))))
          (let ((sum_again (fp.add RNE others_again (limited damped_again))))
            (ite case_1 (guarded others_again sum_again) sum_again)))))))

; |sigma_0 z| <= f_max, but for its rounding; f_max is at most FLT_MAX/16
(assert (fp.leq (fp.abs elastic) (fp #b0 #xfc #b00000000000000000000000)))

(assert (not (is_finite force)))
(check-sat)
