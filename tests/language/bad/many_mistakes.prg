HS=1000
HSPDD=1000
STOP
X=1000
V1=V2+3+4
IF V1=1 AND V2=2
END IF
IF V1==1
ENDIF
WHILE V1
ENDWHILE
HOMEX
DI9=1
MSTX=1
V100=1
HSPD=PX
TOC=V1
HSPD=0
DELAY=V1
X99999999999
X-999999999
WAIT
GOSUB 4
GOSUB 32
V1=(V2+1)
V1=5/0
"foo"
1000
SSPX=10
SL=2
SR2=1
V1=SSPDX
V1=-V2
LOOP
END
;# for dmx-k-sa
;# error 1:1 A program says HSPD.
;# error 2:1 Is it HSPD?
;# error 3:1 STOPX
;# error 4:2 A move has no =
;# error 5:8 one operation
;# error 6:9 compares two values once
;# error 7:1 one word: ENDIF
;# error 8:6 written =
;# error 10:9 comparison is missing
;# error 12:1 direction
;# error 13:1 DI1 to DI6
;# error 14:1 only be read
;# error 15:1 V0 to V99
;# error 16:6 variable on the line above
;# error 17:5 only a number
;# error 18:6 1 to 6,000,000
;# error 19:7 not a variable
;# error 20:2 28 bits
;# error 21:2 28 bits
;# error 22:1 WAITX
;# error 23:1 no SUB 4
;# error 24:7 0 to 31
;# error 25:4 no brackets
;# warning 26:6 division by zero
;# error 27:1 no meaning
;# error 28:1 begins with a word
;# error 29:1 Is it SSPDX?
;# error 30:4 0 to 1
;# error 31:3 SR0 to SR1
;# error 32:4 only be written
;# error 33:4 minus sign
;# error 34:1 is not a statement
