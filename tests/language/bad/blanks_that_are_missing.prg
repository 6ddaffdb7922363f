IFV1=1
WHILEDI1=1
X1000 V2
ENDWHILE
ENDIF
GOSUBV1
END
;# for pmx-4ex-sa dmx-k-sa
;# error 1:1 IF V1
;# error 2:1 WHILE DI1
;# error 3:7 letter of the axis is missing
;# error 6:1 GOSUB takes only a number
