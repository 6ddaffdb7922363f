WHILE 1=1
  IF V1=1
    V2=1
ENDWHILE
ENDIF
ELSE
IF V1=1
ELSE
ELSE
ELSEIF V1=2
ENDIF
IF V1=2
END
SUB 1
WHILE V1=1
;# for pmx-4ex-sa dmx-k-sa
;# error 2:3 no ENDIF
;# error 5:1 no IF above
;# error 6:1 no IF above
;# error 9:1 has an ELSE already
;# error 10:1 after ELSE
;# error 12:1 no ENDIF
;# error 15:1 no ENDWHILE
;# error 15:11 ENDSUB is missing below
