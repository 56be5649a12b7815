------- OpenFAST INPUT FILE -------------------------------------------
A whole small turbine, made up for the tests of Spoke
---------------------- SIMULATION CONTROL --------------------------------------
False         Echo            - Echo input data (flag)
"FATAL"       AbortLevel      - Error level (string)
20            TMax            - Total run time (s)
0.005         DT              - Recommended module time step (s)
2             InterpOrder     - Interpolation order (-)
---------------------- FEATURE SWITCHES AND FLAGS ------------------------------
1             CompElast       - Structure (switch) {1=ElastoDyn; 2=ElastoDyn + BeamDyn for blades}
1             CompInflow      - Wind (switch) {0=still air; 1=InflowWind}
2             CompAero        - Aerodynamic loads (switch) {0=None; 2=AeroDyn}
1             CompServo       - Control (switch) {0=None; 1=ServoDyn}
0             CompHydro       - Water (switch)
0             CompSub         - Substructure (switch)
0             CompMooring     - Mooring (switch)
0             CompIce         - Ice (switch)
0             MHK             - Turbine in water (switch)
---------------------- ENVIRONMENTAL CONDITIONS --------------------------------
9.81          Gravity         - Gravitational acceleration (m/s^2)
1.21          AirDens         - Air density (kg/m^3)
1.5E-05       KinVisc         - Kinematic viscosity (m^2/s)
---------------------- INPUT FILES ---------------------------------------------
"small_turbine_ElastoDyn.dat"    EDFile          - ElastoDyn (quoted string)
"small_BeamDyn.dat"              BDBldFile(1)    - BeamDyn, blade 1 (quoted string)
"small_BeamDyn.dat"              BDBldFile(2)    - BeamDyn, blade 2 (quoted string)
"small_BeamDyn.dat"              BDBldFile(3)    - BeamDyn, blade 3 (quoted string)
"small_turbine_InflowWind.dat"   InflowFile      - InflowWind (quoted string)
"small_turbine_AeroDyn.dat"      AeroFile        - AeroDyn (quoted string)
"small_turbine_ServoDyn.dat"     ServoFile       - ServoDyn (quoted string)
"unused"                         HydroFile       - HydroDyn (quoted string)
---------------------- OUTPUT --------------------------------------------------
True          SumPrint        - Summary (flag)
0.05          DT_Out          - Time step of tabular output (s)
