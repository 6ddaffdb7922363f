; A program of a DMX on a PMX.
LTX=1
DRVRC=1000
V1=LTSX
SL=1
V2=PS
DI9=1
END
;# for pmx-4ex-sa
;# error 2:1 belongs to the DMX-K-SA
;# error 3:1 belongs to the DMX-K-SA
;# error 4:4 belongs to the DMX-K-SA
;# error 5:1 letter of its axis
;# error 6:4 letter of its axis
;# error 7:1 DI1 to DI8
