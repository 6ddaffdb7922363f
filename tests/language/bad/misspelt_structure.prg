IFF V1=1
WHLE V1<3
V1=V1+1
ENDWILE
ENDFI
GOSUB 1
END
SBU 1
V1=2
ENDSBU
;# for pmx-4ex-sa dmx-k-sa
;# error 1:1 Is it IF?
;# error 2:1 Is it WHILE?
;# error 4:1 Is it ENDWHILE?
;# error 5:1 Is it ENDIF?
;# error 8:1 Is it SUB?
;# error 10:1 Is it ENDSUB?
