WAIT X
HOME Y+
STOP Z
P X=0
DELAY 1000
V1==5
V1
X
GOSUB
IF (V1=1)
ENDIF
ELSE IF V1=2
V1=5,6
X10,Y20
X1X2
ENDIF ENDIF
=5
V1=
V1=2−1
PRG
END
;# for pmx-4ex-sa
;# error 1:1 one word: WAITX
;# error 2:1 one word: HOMEY
;# error 3:1 one word: STOPZ
;# error 4:1 one word: PX
;# error 5:7 DELAY needs =
;# error 6:3 A single =
;# error 7:3 needs = and a value
;# error 8:2 A number is missing
;# error 9:6 A number is missing
;# error 10:4 no brackets
;# error 12:1 one word: ELSEIF
;# error 12:1 ELSEIF has no IF
;# error 13:5 no commas
;# error 14:4 no commas
;# error 15:3 X appears twice
;# error 16:1 ENDIF has no IF above it
;# error 16:7 Nothing may follow
;# error 17:1 begins with a word
;# error 18:4 A value is missing
;# error 19:5 not a minus sign
;# error 20:1 END is missing above
;# error 20:4 A number is missing
