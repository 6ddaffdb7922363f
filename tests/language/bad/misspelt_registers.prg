EN=1
IX=5
SB=1
X100
WAITX
END
;# for pmx-4ex-sa
;# error 1:1
;# error 2:1
;# error 3:1
