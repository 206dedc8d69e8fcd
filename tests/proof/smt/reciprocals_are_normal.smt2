; make_point(): where the product has a reciprocal, both reciprocals are positive, normal and finite.
(set-logic QF_FP)
(define-sort F () Float32)
(define-fun zero () F (_ +zero 8 24))
(define-fun one () F (fp #b0 #x7f #b00000000000000000000000))
(define-fun least () F (fp #b0 #x01 #b00000000000000000000000)) ; FLT_MIN
(declare-const z_ss F)
(declare-const span F)
(assert (fp.leq least span))
(assert (fp.leq span z_ss))
(assert (fp.leq z_ss (fp #b0 #xfb #b00000000000000000000000))) ; 2^124
(define-fun product () F (fp.mul RNE z_ss span))
(assert (fp.geq product least))
(assert (fp.lt product (fp #b0 #xfd #b00000000000000000000000))) ; 2^126
(define-fun both () F (fp.div RNE one product))
(define-fun inv_z_ss () F (fp.mul RNE both span))
(define-fun inv_span () F (fp.mul RNE both z_ss))
(assert (not (and (fp.isNormal inv_z_ss) (fp.isPositive inv_z_ss) (fp.isNormal inv_span) (fp.isPositive inv_span))))
(check-sat)
