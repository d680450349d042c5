" Vim syntax file for scripts of tsim, made by `tsim -grammar vim`
if exists("b:current_syntax")
  finish
endif
syn case match
syn iskeyword @,48-57,_,/,-
syn sync minlines=50

syn match tsimNumber /\<[-+]\=\d\+\%(\.\d*\)\=\%([eE][-+]\=\d\+\)\=\>/
syn match tsimNumber /[-+]\=\.\d\+\%([eE][-+]\=\d\+\)\=\>/
syn match tsimReference /\<[cfv]_[A-Za-z0-9_]\+\%(\[[0-9*]\+\]\)*/
syn match tsimVariable /\$\%({[^}]*}\|[A-Za-z0-9_]\)/
syn region tsimFormula matchgroup=tsimVariable start=/\$(/ end=/)/ contains=tsimInner,tsimNumber,tsimReference,tsimVariable,tsimFunction,tsimName
syn region tsimInner contained start=/(/ end=/)/ transparent contains=tsimInner,tsimNumber,tsimReference,tsimVariable,tsimFunction,tsimName
syn region tsimString start=/"/ end=/"/ contains=tsimVariable,tsimFormula
syn region tsimString start=/'/ end=/'/ contains=tsimVariable,tsimFormula
syn region tsimString start=/"""/ end=/"""/ contains=tsimVariable,tsimFormula
syn match tsimContinuation /&\s*$/
syn match tsimComment /#.*$/ contains=@Spell

" keywords and words to choose from
syn keyword tsimKeyword  all NULL INF EDGE SELF yes no on off then elif else cell fill
syn keyword tsimKeyword  restitution wall_restitution roughness lower upper start seed
syn keyword tsimKeyword  obstacles order exact blocks contact offset centre any directions
syn keyword tsimKeyword  random nearest table partner turns keeps wall_normal speed
syn match tsimKeyword /\<velocity\>/ 
syn keyword tsimKeyword  E nu G kappa lambda yield sigma_c tau_c sigma_compression scatter
syn keyword tsimKeyword  none normal weibull deviation shape damping damping_normal
syn keyword tsimKeyword  damping_shear damping_bending damping_twist store/local
syn keyword tsimKeyword  overlay/pair smooth normalize break break/no volume/factor
syn keyword tsimKeyword  stressBreak createBondAlways tensionStress compressionStress
syn keyword tsimKeyword  shearStress normalTorqueStress shearTorqueStress dampingBond
syn keyword tsimKeyword  ratioTensionCompression temperatureBreak dampingBondSmooth
syn keyword tsimKeyword  dissipationBond druckerPrager stiffness ultimate kn ks ratio
syn keyword tsimKeyword  soften soften_by tension both friction_angle beta map array hash
syn keyword tsimKeyword  id first sort x y z shift rcb weight out tilt small large
syn match tsimKeyword /\<units\>/ 
syn match tsimKeyword /\<lattice\>/ 
syn match tsimKeyword /\<box\>/ 
syn keyword tsimKeyword  mode single multi multi/old vel cutoff cutoff/multi reduce/multi
syn match tsimKeyword /\<group\>/ 
syn keyword tsimKeyword  brick tiled
syn match tsimKeyword /\<region\>/ 
syn keyword tsimKeyword  remap overlap maxtry mesh basis subset var
syn match tsimKeyword /\<set\>/ 
syn keyword tsimKeyword  mol rotate many gap single/bond bond/types extra/bond/per/atom
syn keyword tsimKeyword  extra/special/per/atom angle/types dihedral/types improper/types
syn keyword tsimKeyword  extra/angle/per/atom extra/dihedral/per/atom
syn keyword tsimKeyword  extra/improper/per/atom porosity fraction count
syn match tsimKeyword /\<variable\>/ 
syn keyword tsimKeyword  compress bond atom stats remove special undo move ramp every
syn keyword tsimKeyword  thresh format pad delay append
syn match tsimKeyword /\<label\>/ 
syn keyword tsimKeyword  time maxfiles element scale image refresh header buffer compressor
syn keyword tsimKeyword  zlib lz4 flush pbc binary fileper nfile acolor adiam amap atrans
syn keyword tsimKeyword  backcolor backcolor2 bcolor bdiam bitrate bmap boxcolor cmap color
syn keyword tsimKeyword  framerate gmap lights smap screen
syn match tsimKeyword /\<log\>/ 
syn keyword tsimKeyword  xlo xhi ylo yhi zlo zhi wall slip inlet outlet pressure
syn keyword tsimKeyword  hydrostatic update step once uniform geometric fine lo hi tanh
syn keyword tsimKeyword  around before inside faces type union subtract intersect empty
syn keyword tsimKeyword  initialize
syn match tsimKeyword /\<clear\>/ 
syn keyword tsimKeyword  delete dynamic static
syn match tsimKeyword /\<include\>/ 
syn keyword tsimKeyword  molecule sc bcc fcc hcp diamond sq sq2 hex custom origin orient
syn keyword tsimKeyword  spacing a1 a2 a3 lammps file open plate length width disk radius
syn keyword tsimKeyword  hole sphere cylinder tube thickness cone radlo radhi revolve
syn keyword tsimKeyword  hopper half_angle height stem wedge depth ends drum lifters screw
syn keyword tsimKeyword  shaft pitch hand right left periodic mixer blades at base axis
syn keyword tsimKeyword  angle segments error size normals outward inward primitive check
syn keyword tsimKeyword  binsize contact_distance_factor page one cluster collection/type
syn keyword tsimKeyword  collection/interval exclude bin nsq fixed omp neigh grain tail mix
syn keyword tsimKeyword  arithmetic sixthpower universe grid part numa add nocoeff
syn keyword tsimKeyword  extra/atom/types extra/bond/types extra/angle/types
syn keyword tsimKeyword  extra/dihedral/types extra/improper/types
syn match tsimKeyword /\<fix\>/ 
syn keyword tsimKeyword  replace trim purge bbox title renew picture last skip stop
syn match tsimKeyword /\<dump\>/ 
syn keyword tsimKeyword  post warn upto pre unsafe verlet diameter density density/disc
syn match tsimKeyword /\<mass\>/ 
syn keyword tsimKeyword  vx vy vz omegax omegay omegaz omega type/fraction type/ratio
syn keyword tsimKeyword  type/subset property/atom d_NAME i_NAME d2_NAME i2_NAME lj coul
syn keyword tsimKeyword  lj/coul dihedral lost ignore lost/bond norm line temp press si cgs
syn keyword tsimKeyword  micro real metal electron nano index loop world uloop string
syn keyword tsimKeyword  getenv
syn match tsimKeyword /\<timer\>/ 
syn keyword tsimKeyword  internal atomfile equal vector create zero linear angular
syn keyword tsimKeyword  angularIndividual sum dist gaussian mom rot local geom bias pair
syn keyword tsimKeyword  ii ij nofix modify noinit threshold hardness up column quantile
syn keyword tsimKeyword  area discard default mixed bound reduced nchunk limit ids nfreq
syn keyword tsimKeyword  walls type/include between cells values interpolation cubic
syn keyword tsimKeyword  solid_fraction amount load bumpiness upper_wall_restitution
syn keyword tsimKeyword  upper_roughness upper_bumpiness friction tangential packing theory
syn keyword tsimKeyword  lun garzo/dufty radial lun/savage carnahan/starling torquato
syn keyword tsimKeyword  branch dense dilute points tolerance shear_rate kspace tensor
syn keyword tsimKeyword  lacey kramer poole rsd intensity above chunks number volume least
syn keyword tsimKeyword  particles contacts reference neighbors com average property xcm
syn keyword tsimKeyword  vcm fcm torque quat angmom masstotal inertia clumptype
syn keyword tsimKeyword  id_multisphere ex_space ey_space ez_space bond/type region_count
syn keyword tsimKeyword  tracer reset_marker min max ave sumsq avesq sumabs aveabs minabs
syn keyword tsimKeyword  maxabs std inputs peratom update_on_run_end ridge plane center
syn keyword tsimKeyword  winkler halfspace young poisson counter_young counter_poisson
syn keyword tsimKeyword  iterations counter adof cdof mean linear/x linear/y linear/z
syn keyword tsimKeyword  motion translation rotation unbiased xy yz xz xyz dof primitives
syn keyword tsimKeyword  colour u v movie voxel clip slice film arrow view zoom persp axes
syn keyword tsimKeyword  subbox shiny depthcue fsaa ssao legend reset coefficient
syn keyword tsimKeyword  fluid_acceleration two_way energy sample running window overwrite
syn keyword tsimKeyword  title1 title2 title3 auto auto/upper auto/lower full prefactor
syn keyword tsimKeyword  scalar nevery cell_size_relative parallel basevolume_region kind
syn keyword tsimKeyword  global beyond end extra level prob iparam jparam dim vmax
syn match tsimKeyword /\<legacy\>/ 
syn keyword tsimKeyword  couple_every mpi T0 CrankNicolson final delta erate trate wiggle
syn keyword tsimKeyword  flip scheme explicit implicit lagged void sound C1 C2 wob spring
syn keyword tsimKeyword  body clearance summary pf/callback pf/array conductivity capacity
syn keyword tsimKeyword  initial source convection vanleer central donor exchange
syn keyword tsimKeyword  ranz_marshall chute spherical hard soft continue message path
syn keyword tsimKeyword  initial_temperature contact_area area_correction
syn keyword tsimKeyword  store_contact_data euler min_cells relax virtual_mass surface
syn keyword tsimKeyword  spheres distributiontemplate maxattempt overlapcheck stacked
syn keyword tsimKeyword  orientation set_property verbose all_in position direction
syn keyword tsimKeyword  inner_diameter nparticles particlerate massrate insert_every
syn keyword tsimKeyword  random_distribute uncorrelated compress_tags ntry_mc
syn keyword tsimKeyword  check_dist_from_subdomain_border warn_region avoid_meshes
syn keyword tsimKeyword  particles_in_region volumefraction_region mass_in_region
syn keyword tsimKeyword  max_rounds insertion_face extrude_length duration law rubinow
syn keyword tsimKeyword  oesterle saffman mei viscosity inner outer vec_side multiple
syn keyword tsimKeyword  point_at_outlet inside_out writeTime
syn match tsimKeyword /\<delete_atoms\>/ 
syn keyword tsimKeyword  interval sum_property sieveSize sieveSpacing sieveStiffness
syn keyword tsimKeyword  sieveDamping temperature element_exclusion_list precision
syn keyword tsimKeyword  curvature extrude_planar curvature_tolerant heal
syn keyword tsimKeyword  auto_remove_duplicates surface_vel surface_ang_vel reference_point
syn keyword tsimKeyword  stress wear finnie ctrlPV force target_val vel_max kp ki kd pid
syn keyword tsimKeyword  rescale transrot linear/variable period rotate/variable amplitude
syn keyword tsimKeyword  riggle viblin phase vibrot linear/superposable
syn keyword tsimKeyword  linear/variable/superposable rotate/superposable
syn keyword tsimKeyword  rotate/variable/superposable wiggle/superposable
syn keyword tsimKeyword  riggle/superposable viblin/superposable vibrot/superposable
syn keyword tsimKeyword  gravity geometric_prefactor allow_group_and_set allow_heatsource
syn keyword tsimKeyword  by_dimension disc atom_type volume_limit relative nspheres ntry
syn keyword tsimKeyword  bonded inertia_tensor use_volume use_density fflag tflag diam dens
syn keyword tsimKeyword  vol rate
syn match tsimKeyword /\<next\>/ 
syn keyword tsimKeyword  molfrac rigid shake ghost writedata add_region check_region_every
syn keyword tsimKeyword  region_mark mark_step marker_style dirac heaviside
syn keyword tsimKeyword  check_mark_every insert_stream n_tracer peratomtype
syn keyword tsimKeyword  peratomtypepair matrix atomtype atomtypepair massratevariable
syn keyword tsimKeyword  style shrink delete_below integrated_error scale_width tether
syn keyword tsimKeyword  couple constant black white formula correlation noise columns
syn keyword tsimKeyword  waves selfaffine hurst shortest roll longest datum merge method
syn keyword tsimKeyword  divided kernel reach settled inertia_1 inertia_2 arm joint_1
syn keyword tsimKeyword  joint_2 start_1 start_2 model hooke hertz hooke/stiffness
syn keyword tsimKeyword  hooke/modulus hertz/stiffness hooke/hysteresis edinburgh jkr
syn keyword tsimKeyword  history no_history incremental_history jkr_tan cohesion sjkr sjkr2
syn keyword tsimKeyword  easo/capillary/viscous washino/capillary/viscous rolling_friction
syn keyword tsimKeyword  cdt epsd epsd2 epsd3 multicontact limitForce tangential_damping
syn keyword tsimKeyword  absolute_damping ktToKnUser viscous tangential_reduce
syn keyword tsimKeyword  modifyLbVolume limitLiquidContent torsionTorque
syn keyword tsimKeyword  heating_normal_hertz heating_tangential_history
syn keyword tsimKeyword  computeElasticPotential computeDissipatedEnergy
syn keyword tsimKeyword  disableNormalWhenBonded located hooke/history hertz/history
syn keyword tsimKeyword  granular limit_damping n_meshes meshes voxels xplane yplane zplane
syn keyword tsimKeyword  xcylinder ycylinder zcylinder shear impact resolved store_force
syn keyword tsimKeyword  store_force_contact store_force_contact_stress evolve evolve_every
syn keyword tsimKeyword  layer through k deformation cutting modulus cutting_constant
syn keyword tsimKeyword  elastic_constant factor flow_stress depth_ratio force_ratio
syn keyword tsimKeyword  transition sio2 sic glass relaxation crater section segment
syn keyword tsimKeyword  plastic ab2 rk2 rk3 backward substeps courant quick cubista gamma
syn keyword tsimKeyword  form fv fd conservative quadratic body_force pressure_level
syn keyword tsimKeyword  lower_voxel upper_voxel upper_wafer lower_velocity upper_velocity
syn keyword tsimKeyword  lower_stays upper_stays lower_slip upper_slip asperities barus
syn keyword tsimKeyword  roelands ambient pressure_xlo pressure_xhi pressure_ylo
syn keyword tsimKeyword  pressure_yhi floating closed cavitation half reynolds jfo
syn keyword tsimKeyword  cavity_pressure transient stepped
syn match tsimKeyword /\<run\>/ 
syn keyword tsimKeyword  least_gap touching solid axisymmetric point span distance profile
syn keyword tsimKeyword  potential anharmonic generic hertz/material dmt mass_velocity
syn keyword tsimKeyword  viscoelastic tsuji coeff_restitution rolling twisting heat
syn keyword tsimKeyword  unfinished preconditioner diagonal direct multigrid ranks side in
syn keyword tsimKeyword  bounds angle0

" numbers of the simulation and of particles
syn keyword tsimName  id type radius diameter
syn match tsimName /\<mass\>/ 
syn keyword tsimName  density mol x y z vx vy vz fx fy fz omegax omegay omegaz tqx tqy
syn keyword tsimName  tqz xu yu zu xs ys zs xsu ysu zsu ix iy iz proc thread angmomx
syn keyword tsimName  angmomy angmomz nbuild ndanger bonds numbonds numbond brokenbonds
syn keyword tsimName  gonebonds flow_ke flow_px flow_py flow_pz flow_div flow_cfl
syn keyword tsimName  flow_iter flow_res flow_dt flow_time flow_steps step elapsed
syn keyword tsimName  elaplong part time dt cpu tpcpu spcpu cpuremain timeremain cu
syn keyword tsimName  atoms ke erotate pe etotal epair evdwl emol ebond enthalpy ecouple
syn keyword tsimName  econserve ecoul elong etail eangle edihed eimp angles dihedrals
syn keyword tsimName  impropers temp fmax fnorm vol lx ly lz xlo xhi ylo yhi zlo zhi xy
syn keyword tsimName  xz yz xlat ylat zlat cella cellb cellc cellalpha cellbeta
syn keyword tsimName  cellgamma stable_fraction press pxx pyy pzz pxy pxz pyz PI yes no
syn keyword tsimName  true false on off

syn match tsimFunction /\<\%(sqrt\|exp\|ln\|log\|abs\|sign\|sin\|cos\|tan\|asin\|acos\|atan\|atan2\|ceil\|floor\|round\|ternary\|random\|normal\|ramp\|vdisplace\|swiggle\|cwiggle\|stagger\|logfreq\|logfreq2\|logfreq3\|stride\|stride2\|length\|sum\|ave\|min\|max\|trap\|slope\|stderr\|sort\|rsort\|next\|is_file\|is_os\|is_defined\|is_active\|is_available\|extract_setting\|volume\|count\|mass\|ke\|gyration\|xcm\|vcm\|fcm\|angmom\|torque\|inertia\|omega\|bound\|property\|gmask\|rmask\|grmask\)\ze(/

" commands, at the start of a line
syn match tsimCommand /^\s*\%(atom_modify\|atom_style\|automaton_style\|balance\|bond_coeff\|bond_style\|boundary\|box\|change_box\|clear\|comm_modify\|comm_style\|communicate\|compute\|compute_modify\|create_atoms\|create_particles\|create_bonds\|create_box\|delete_atoms\|delete_bonds\|dimension\|displace_atoms\|dump\|dump_modify\|echo\|fix\|fix_modify\|flow_boundary\|flow_grid\|flow_set\|flow_style\|group\|hard_particles\|if\|include\|info\|jump\|label\|lattice\|legacy\|log\|mass\|material\|mesh_primitive\|modify_timing\|neigh_modify\|neighbor\|newton\|next\|package\|pair_coeff\|pair_modify\|pair_style\|partition\|partitioner_style\|pressure_style\|print\|processors\|quit\|read_data\|read_dump\|read_restart\|region\|replicate\|report\|rerun\|reset_timestep\|restart\|review\|run\|run_style\|run_time\|set\|shell\|soft_particles\|special_bonds\|suffix\|thermo\|thermo_log\|thermo_modify\|thermo_style\|timer\|timestep\|uncompute\|undump\|unfix\|units\|variable\|velocity\|write_data\|write_dump\|write_restart\|write_restart_on_signal\)\ze\%(\s\|$\)/

" styles, behind their command, name and group
syn match tsimHead /^\s*fix\s\+\S\+\s\+\S\+\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_fix
syn keyword tsim_fix contained adapt added_mass addforce ave/atom ave/chunk ave/correlate
syn keyword tsim_fix contained ave/error ave/euler ave/histo ave/histo/weight ave/period
syn keyword tsim_fix contained ave/spatial ave/time aveforce
syn match tsim_fix /\<balance\>/ contained
syn keyword tsim_fix contained bond/break bond/breakage bond/create bond/create/gran
syn keyword tsim_fix contained bond/store/local buoyancy check/timestep/bond check/timestep/gran
syn keyword tsim_fix contained controller couple/cfd couple/cfd/convection couple/cfd/force
syn keyword tsim_fix contained couple/cfd/force/implicit damping/cundall deform drag
syn keyword tsim_fix contained drag/beetstra drag/carlson_hoglund drag/di_felice drag/ergun
syn keyword tsim_fix contained drag/gidaspow drag/koch_hill drag/schiller_naumann drag/stokes
syn keyword tsim_fix contained drag/wen_yu drill/bit energy/ledger enforce2d evaporate external
syn keyword tsim_fix contained flow/pressure_gradient flow/scalar freeze gravity halt heat/gran
syn keyword tsim_fix contained heat/gran/conduction immersed/boundary insert/gap insert/jet
syn keyword tsim_fix contained insert/pack insert/pack/dense insert/rate/region insert/stream
syn keyword tsim_fix contained langevin lift/magnus lift/saffman lineforce lubrication
syn keyword tsim_fix contained massflow/mesh massflow/mesh/sieve mesh/surface mesh/surface/planar
syn keyword tsim_fix contained mesh/surface/stress mesh/surface/stress/servo momentum move
syn keyword tsim_fix contained move/mesh move/mesh/file move/mesh/gran move/mesh/free
syn keyword tsim_fix contained multicontact/halfspace multisphere nve nve/euler nve/limit
syn keyword tsim_fix contained nve/noforce nve/sphere nve/bpm/sphere nve/sphere/bpm
syn keyword tsim_fix contained nve/symplectic particledistribution/discrete
syn keyword tsim_fix contained particledistribution/discrete/massbased
syn keyword tsim_fix contained particledistribution/discrete/numberbased
syn keyword tsim_fix contained particletemplate/multiplespheres particletemplate/multisphere
syn keyword tsim_fix contained particletemplate/sphere planeforce pour
syn match tsim_fix /\<print\>/ contained
syn keyword tsim_fix contained property/atom property/atom/regiontracer/time property/atom/tracer
syn keyword tsim_fix contained property/atom/tracer/stream property/global custom_property/global
syn keyword tsim_fix contained property/atomtype property/atomtypepair recenter remove rigid
syn keyword tsim_fix contained rigid/nve rigid/nve/small rigid/small scale/diameter setforce
syn keyword tsim_fix contained spring spring/self store/force store/state surface/heat
syn keyword tsim_fix contained surface/impacts surface/voxel vector viscous viscous/sphere
syn keyword tsim_fix contained void_fraction wafer wall/gran wall/gran/region wall/reflect
syn keyword tsim_fix contained wear/archard wear/bitter wear/finnie wear/formula
syn keyword tsim_fix contained wear/neilson/gilchrist wear/oka wear/zhao/chang
syn keyword tsim_fix contained wear/zhao/chang/contact
hi def link tsim_fix Type
syn match tsimHead /^\s*compute\s\+\S\+\s\+\S\+\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_compute
syn keyword tsim_compute contained active/paml active/pi active/pml aggregate/atom angmom/chunk
syn keyword tsim_compute contained automaton/profile bed/height bond/counter bond/local bonds
syn keyword tsim_compute contained chunk/atom chunk/spread/atom cluster/atom com com/chunk
syn keyword tsim_compute contained contact/atom contact/atom/gran contacts coord/atom coordination
syn keyword tsim_compute contained count/type displace/atom erotate erotate/multisphere erotate/rigid
syn keyword tsim_compute contained erotate/sphere erotate/sphere/atom fabric film film/atom flow/flux
syn keyword tsim_compute contained flow/force flow/line flow/plane flow/probe fragment/atom
syn keyword tsim_compute contained granular/couette granular/shear group/group gyration
syn keyword tsim_compute contained gyration/chunk inertia/chunk ke ke/atom ke/multisphere ke/rigid
syn keyword tsim_compute contained leave mixing mixing/contact mixing/gmmi mixing/neighbor msd
syn keyword tsim_compute contained msd/chunk multisphere rigid multisphere/single nbond/atom
syn keyword tsim_compute contained neighbor/atom nparticles/tracer/region omega/chunk pair/gran/local
syn keyword tsim_compute contained pair/gran/local/bond pair/local pe pe/atom pressure property/atom
syn keyword tsim_compute contained property/chunk property/local quantile rdf reduce reduce/chunk
syn keyword tsim_compute contained reduce/region repose/angle slice squeeze/atom stress/atom
syn keyword tsim_compute contained stress/region surface/contact temp temp/chunk temp/com
syn keyword tsim_compute contained temp/granular temp/granular/chunk temp/partial temp/profile
syn keyword tsim_compute contained temp/ramp temp/region temp/sphere torque/chunk vacf vcm/chunk
syn keyword tsim_compute contained wall/gran/local
hi def link tsim_compute Type
syn match tsimHead /^\s*region\s\+\S\+\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_region
syn keyword tsim_region contained block cone cylinder ellipsoid intersect mesh/hex mesh/tet plane
syn keyword tsim_region contained prism sphere union wedge
hi def link tsim_region Type
syn match tsimHead /^\s*dump\s\+\S\+\s\+\S\+\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_dump
syn keyword tsim_dump contained atom atom/gz atom/mpiio automaton/png automaton/vtk custom
syn keyword tsim_dump contained custom/gz custom/mpiio custom/vtk euler/vtk flow/vtk h5md image
syn keyword tsim_dump contained local local/gz local/gran/vtk local/vtk mesh/stl stl mesh/vtk
syn keyword tsim_dump contained mesh/gran/VTK movie
syn match tsim_dump /\<restart\>/ contained
syn keyword tsim_dump contained voxel/vtk xyz xyz/gz xyz/mpiio
hi def link tsim_dump Type
syn match tsimHead /^\s*pair_style\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_pair
syn keyword tsim_pair contained bpm/spring gran gran/hertz/history gran/hooke gran/hooke/history
syn keyword tsim_pair contained granular spring/dashpot
hi def link tsim_pair Type
syn match tsimHead /^\s*bond_style\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_bond
syn keyword tsim_bond contained beam bpm/rotational bpm/spring cohesion contact gran harmonic
syn keyword tsim_bond contained parallel
hi def link tsim_bond Type
syn match tsimHead /^\s*flow_style\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_flow
syn keyword tsim_flow contained projection reynolds stagnation uniform
hi def link tsim_flow Type
syn match tsimHead /^\s*pressure_style\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_pressure
syn keyword tsim_pressure contained cg direct hypre multigrid sor
hi def link tsim_pressure Type
syn match tsimHead /^\s*automaton_style\s\+/ contains=tsimCommand,tsimVariable nextgroup=tsim_automaton
syn keyword tsim_automaton contained granular
hi def link tsim_automaton Type

hi def link tsimCommand Statement
hi def link tsimKeyword Identifier
hi def link tsimName Constant
hi def link tsimFunction Function
hi def link tsimNumber Number
hi def link tsimReference Special
hi def link tsimVariable PreProc
hi def link tsimString String
hi def link tsimContinuation Delimiter
hi def link tsimComment Comment

let b:current_syntax = "tsim"
