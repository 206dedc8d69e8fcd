; deflecting_part(), dx > 0: what deflects is positive wherever its first part is. That part is at most dx, but
; for its rounding; then dx - part may be negative, but by no more than that.
(set-logic QF_FP)
(define-sort F () Float32)
(define-fun zero () F (_ +zero 8 24))
(define-fun one () F (fp #b0 #x7f #b00000000000000000000000))
(define-fun near_one () F (fp #b0 #x7f #b00000000000000000010000)) ; 1 + 2^-19
(declare-const dx F)
(declare-const part F)
(declare-const elastic_share F)
(assert (fp.gt dx zero))
(assert (fp.leq dx (fp #b0 #xfb #b00000000000000000000000))) ; 2^124
(assert (fp.gt part zero))
(assert (fp.leq part (fp.mul RNE dx near_one)))
(assert (fp.geq elastic_share zero))
(assert (fp.leq elastic_share one))
(define-fun y () F (fp.add RNE part (fp.mul RNE elastic_share (fp.sub RNE dx part))))
(assert (not (fp.gt y zero)))
(check-sat)
