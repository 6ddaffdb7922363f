WHILE V0<1
  WHILE V1<1
    WHILE V2<1
      WHILE V3<1
        WHILE V4<1
          WHILE V5<1
            WHILE V6<1
              WHILE V7<1
                WHILE V8<1
                  WHILE V9<1
                    WHILE V10<1
                      WHILE V11<1
                        WHILE V12<1
                          WHILE V13<1
                            WHILE V14<1
                              WHILE V15<1
                                V99=V99+1
                              V15=1
                              ENDWHILE
                            V14=1
                            ENDWHILE
                          V13=1
                          ENDWHILE
                        V12=1
                        ENDWHILE
                      V11=1
                      ENDWHILE
                    V10=1
                    ENDWHILE
                  V9=1
                  ENDWHILE
                V8=1
                ENDWHILE
              V7=1
              ENDWHILE
            V6=1
            ENDWHILE
          V5=1
          ENDWHILE
        V4=1
        ENDWHILE
      V3=1
      ENDWHILE
    V2=1
    ENDWHILE
  V1=1
  ENDWHILE
V0=1
ENDWHILE
END
;# for pmx-4ex-sa dmx-k-sa
;# after 500 V99=1 V0=1 V15=1 state0=0
