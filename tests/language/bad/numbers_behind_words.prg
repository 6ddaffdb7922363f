ARCP100:0:90000:0
SSPDX3000
T5
HSPDD3000
GOSUBB5
END
;# for pmx-4ex-sa
;# error 1:17 more than 0
;# error 2:1 Is it SSPDX=3000?
;# error 3:1 is not a statement
;# error 4:1 Is it HSPD=3000?
;# error 5:1 Is it GOSUB5?
