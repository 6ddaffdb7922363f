; 0 1 2 3: odd numbers into V10, even into V11, 3 into V12
WHILE V1<4
  V2=V1&1
  IF V2=0
    IF V1=0
    ELSE
      V11=V11+V1
    ENDIF
  ELSEIF V1=3
    V12=V1
    WHILE V3<2
      V3=V3+1
      IF V3=2
        V13=7
      ENDIF
    ENDWHILE
  ELSE
    V10=V10+V1
  ENDIF
  V1=V1+1
ENDWHILE
END
;# for pmx-4ex-sa dmx-k-sa
;# after 200 V10=1 V11=2 V12=3 V13=7 V3=2 state0=0
