---@meta gnomon
-- made from engine/script/scene_schema.cpp; GNOMON_UPDATE=1 engine_script_tests writes it anew.

---@class gnomon
local g = {}

---The level: its fields, and everything in it as a list. Lists inside the list are unfolded.
---@class (exact) gnomon.scene
---@field preset? "low"|"medium"|"high"|"ultra" Fills in whatever budget and shadow do not say, from scripts/gnomon/presets.lua. (one of "low", "medium", "high", "ultra")
---@field budget? gnomon.budget What shadows may cost. (a table)
---@field shadow? gnomon.shadow Wishes for all shadows of the level. (a table)
---@field ambient? number[] Light from everywhere, linear, relative to the exposure. At 0 shadows are black, over 1 they wash out. (a list of 3 numbers, each 0 to 100; default {0.2, 0.2, 0.2})
---@field exposure? number Multiplies light before tone mapping: too little is night, too much is white. Without it a value is found from the lights. (more than 0 and at most 1000000)
---@field on_update? fun(dt: number) Called before each frame with the seconds since the last one; see "While a level runs". When it fails it is not called again, and the level goes on. (a function)
---@field [integer] table everything in the level

---The level: its fields, and everything in it as a list. Lists inside the list are unfolded.
---@param fields gnomon.scene
---@return gnomon.scene
function g.scene(fields) end

---A directional light: so far away that its rays are parallel.
---@class (exact) gnomon.sun
---@field name? string What rules, messages and files call this light; unique in the level. Without it a name is made up, and a reload may take it for another one. (a name: up to 64 letters, digits, spaces, - or _ (no / \ # " : * ? < > |))
---@field direction? number[] The way the light travels; any length but 0. (a list of 3 numbers, each -10000000 to 10000000; default {-0.4, -1, -0.3})
---@field illuminance? number Strength on a surface that faces it; noon is 100000, an overcast day 10000, the moon 0.2. (0 to 1000000 lux; default 60000)
---@field color? number[] Linear red, green, blue that multiply the strength; all 0 is dark, over 1 is a stronger light. (a list of 3 numbers, each 0 to 100; default {1, 1, 1})
---@field angular_size? number Full angle under which the light is seen: 0 gives hard shadows, 0.53 is the sun, large values are a bright patch of sky whose shadows cost samples. (0 to 90 deg; default 0.53)
---@field on? boolean False keeps the light in the level but dark. (true or false; default true)
---@field shadow? gnomon.light_shadow What is asked of this light's shadows. (a table)

---A directional light: so far away that its rays are parallel.
---@param fields gnomon.sun
---@return gnomon.sun
function g.sun(fields) end

---A light that shines into a cone.
---@class (exact) gnomon.spot
---@field name? string What rules, messages and files call this light; unique in the level. Without it a name is made up, and a reload may take it for another one. (a name: up to 64 letters, digits, spaces, - or _ (no / \ # " : * ? < > |))
---@field position? number[] Where it is: x, y (up), z. (a list of 3 numbers, each -10000000 to 10000000 m; default {0, 2, 0})
---@field intensity? number Strength in its brightest direction; a candle is 1, a household bulb about 100, a stage light 100000. (0 to 100000000 cd; default 1000)
---@field color? number[] Linear red, green, blue that multiply the strength; all 0 is dark, over 1 is a stronger light. (a list of 3 numbers, each 0 to 100; default {1, 1, 1})
---@field range? number Where the light ends. Too short cuts it off visibly; without it the light reaches everything, and so do its costs. (more than 0 and at most 1000000 m)
---@field radius? number Radius of the shining sphere: 0 gives hard shadows, large values soft ones that cost samples. (0 to 100 m; default 0)
---@field on? boolean False keeps the light in the level but dark. (true or false; default true)
---@field shadow? gnomon.light_shadow What is asked of this light's shadows. (a table)
---@field direction? number[] The way the axis of the light points; any length but 0. Or say target. (a list of 3 numbers, each -10000000 to 10000000; default {0, -1, 0})
---@field target? number[] A point on the axis, instead of direction. (a list of 3 numbers, each -10000000 to 10000000 m)
---@field outer_angle? number Half-angle from the axis at which the light ends. Near 0 nothing is lit; near 90 maps get coarse, and a lamp is the better light. (more than 0 and less than 90 deg; default 45)
---@field inner_angle? number Half-angle from the axis at which the fall-off begins; less than outer_angle. Equal angles would cut the light off like a knife. (at least 0 and less than 90 deg; default 0)

---A light that shines into a cone.
---@param fields gnomon.spot
---@return gnomon.spot
function g.spot(fields) end

---A point light: it shines in all directions.
---@class (exact) gnomon.lamp
---@field name? string What rules, messages and files call this light; unique in the level. Without it a name is made up, and a reload may take it for another one. (a name: up to 64 letters, digits, spaces, - or _ (no / \ # " : * ? < > |))
---@field position? number[] Where it is: x, y (up), z. (a list of 3 numbers, each -10000000 to 10000000 m; default {0, 2, 0})
---@field intensity? number Strength in its brightest direction; a candle is 1, a household bulb about 100, a stage light 100000. (0 to 100000000 cd; default 100)
---@field color? number[] Linear red, green, blue that multiply the strength; all 0 is dark, over 1 is a stronger light. (a list of 3 numbers, each 0 to 100; default {1, 1, 1})
---@field range? number Where the light ends. Too short cuts it off visibly; without it the light reaches everything, and so do its costs. (more than 0 and at most 1000000 m)
---@field radius? number Radius of the shining sphere: 0 gives hard shadows, large values soft ones that cost samples. (0 to 100 m; default 0)
---@field on? boolean False keeps the light in the level but dark. (true or false; default true)
---@field shadow? gnomon.light_shadow What is asked of this light's shadows. (a table)

---A point light: it shines in all directions.
---@param fields gnomon.lamp
---@return gnomon.lamp
function g.lamp(fields) end

---A thing to see: a model file or a built-in shape.
---@class (exact) gnomon.model
---@field name? string What rules, messages and files call this model; unique in the level. Without it a name is made up, and a reload may take it for another one. (a name: up to 64 letters, digits, spaces, - or _ (no / \ # " : * ? < > |))
---@field file? string A .glb or .gltf file, relative to the level's folder. Either this or shape. (a string)
---@field shape? "box"|"plane"|"sphere"|"cylinder"|"cone"|"torus" One of the built-in bodies, centred on its position. A plane is open and flat: it casts a shadow like paper. (one of "box", "plane", "sphere", "cylinder", "cone", "torus")
---@field size? number[] Full extents of a shape: x, y, z, or x, z for a plane. The y of a torus is the thickness of its ring. (a list of 2 to 3 numbers, each more than 0 and at most 100000 m; default {1, 1, 1})
---@field color? number[] Linear red, green, blue of a shape; 1 is whiter than paper (0.8), and 0 hides all shadows. (a list of 3 numbers, each 0 to 1; default {0.8, 0.8, 0.8})
---@field path? string Name of a path to go along, looking (with the side towards z) the way it leads. It decides position and rotation. (a string)
---@field path_speed? number How fast it goes along its path; 0 stands still, negative walks the other way. (-100 to 100 m/s; default 1.2)
---@field path_start? number Share of the path at which it begins. (0 to 1; default 0)
---@field position? number[] Where it is: x, y (up), z. (a list of 3 numbers, each -10000000 to 10000000 m; default {0, 0, 0})
---@field rotation? number[] Turns about x, y and z, applied in the order z, x, y (roll, pitch, yaw). (a list of 3 numbers, each -3600 to 3600 deg; default {0, 0, 0})
---@field scale? number|number[] One factor or three, none 0; a negative one mirrors. Files in centimetres want 0.01. (a number or a list of 3 numbers, each -10000 to 10000; default {1, 1, 1})
---@field casts? boolean Whether it throws shadows; big flat ground need not. (true or false; default true)
---@field receives? boolean Whether shadows are seen on it. (true or false; default true)
---@field hero? boolean Whether its shadow is held to a quarter of a pixel; a level with many heroes is dear. (true or false; default false)
---@field animation? string Clip of the file to play; the first one without it. (a string)
---@field animation_speed? number 1 is as authored, 0 stands still, negative runs backwards. (-100 to 100; default 1)
---@field animation_start? number Where in the clip it begins, so that many of one file do not march in step. (0 to 10000 s; default 0)
---@field shadow? gnomon.shadow What is asked of shadows on this model. (a table)

---A thing to see: a model file or a built-in shape.
---@param fields gnomon.model
---@return gnomon.model
function g.model(fields) end

---A place to look from. The first one is used when none is asked for.
---@class (exact) gnomon.camera
---@field name? string What rules, messages and files call this camera; unique in the level. Without it a name is made up, and a reload may take it for another one. (a name: up to 64 letters, digits, spaces, - or _ (no / \ # " : * ? < > |))
---@field position? number[] Where it is: x, y (up), z. (a list of 3 numbers, each -10000000 to 10000000 m; default {0, 1.7, 5})
---@field look_at? number[] A point in the middle of the picture; it must not be the position. Or say rotation. (a list of 3 numbers, each -10000000 to 10000000 m; default {0, 0, 0})
---@field rotation? number[] Instead of look_at: turns about x, y and z, applied in the order z, x, y; all 0 looks along -z. (a list of 3 numbers, each -3600 to 3600 deg)
---@field fov? number Full vertical angle of view: small is a telescope, over 120 stretches the corners. (1 to 170 deg; default 60)
---@field near? number What is nearer is not seen; too small wastes depth precision far away. (0.0001 to 1000 m; default 0.1)

---A place to look from. The first one is used when none is asked for.
---@param fields gnomon.camera
---@return gnomon.camera
function g.camera(fields) end

---A wish for some shadows only. What is left out matches everything; later rules win.
---@class (exact) gnomon.rule
---@field light? string Name of a light. (a string)
---@field receiver? string Name of a model that shadows fall on, or "model/node" inside of it. (a string)
---@field caster? string Name of a model that throws shadows, or "model/node" inside of it. (a string)
---@field distance? number The rule holds from this distance to the camera on. (0 to 10000000 m)
---@field technique? "auto"|"none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced" The technique to use whatever it costs; "auto" leaves the choice to the picker. (one of "auto", "none", "blob", "planar", "shadow_texture", "volume", "cascaded_map", "spot_map", "cube_map", "traced")
---@field never? "none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced"|("none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced")[] Techniques that must not be picked; with too many of them nothing fits the budget. (one or a list of "none", "blob", "planar", "shadow_texture", "volume", "cascaded_map", "spot_map", "cube_map", "traced")
---@field error_px? number Accepted displacement of shadow edges. Small values ask for dear techniques; over about 4 edges are seen to be wrong. (0 to 1000 px)
---@field map_size? integer Texels per side of shadow maps. Too few give blocky edges, too many cost memory and time. (a whole number, 16 to 16384 texels)
---@field filter? "nearest"|"bilinear"|"pcf"|"pcss" How shadow maps are looked up: hard and cheap first, soft and dear last. (one of "nearest", "bilinear", "pcf", "pcss")
---@field samples? integer Points on the light that soft techniques try. Few show as bands, many cost time. (a whole number, 1 to 1024)
---@field cascades? integer Maps that share the view of a sun. One is coarse near the camera, four cost four passes. (a whole number, 1 to 4)
---@field proxy? integer How far volumes simplify heroes for what is not near them. 0 keeps every edge, 3 is cheapest and coarsest. (a whole number, 0 to 3)
---@field way? "geometry"|"box"|"boxes"|"plateau"|"texture" How planar shadows are made: from the casters themselves, from boxes in their place, with a soft skirt, or kept in a texture. Without it the cheapest that is right enough. (one of "geometry", "box", "boxes", "plateau", "texture")
---@field refresh? integer Frames that a shadow map or texture serves before it is drawn anew. 1 follows every motion; with more, shadows lag behind what moves. (a whole number, 1 to 1000 frames)

---A wish for some shadows only. What is left out matches everything; later rules win.
---@param fields gnomon.rule
---@return gnomon.rule
function g.rule(fields) end

---A way through the level, straight from point to point.
---@class (exact) gnomon.path
---@field name? string What rules, messages and files call this path; unique in the level. Without it a name is made up, and a reload may take it for another one. (a name: up to 64 letters, digits, spaces, - or _ (no / \ # " : * ? < > |))
---@field points? number[][] The places that it leads through, in their order. (a list of 2 or more places, each a list of 3 numbers, each -10000000 to 10000000 m)
---@field closed? boolean True leads from the last point to the first; false turns back there. (true or false; default true)

---A way through the level, straight from point to point.
---@param fields gnomon.path
---@return gnomon.path
function g.path(fields) end

---Whom the person at the keys is; at most one. Without it the camera flies.
---@class (exact) gnomon.player
---@field position? number[] Where it is: x, y (up), z. (a list of 3 numbers, each -10000000 to 10000000 m; default {0, 0, 0})
---@field heading? number Turn about y with which the player begins; 0 looks along -z, 90 along -x. (-3600 to 3600 deg; default 0)
---@field speed? number How fast the player walks; 1.4 is a stroll, over 4 is running. (more than 0 and at most 100 m/s; default 1.6)
---@field path? string Name of the path that the player follows where nobody is at the keys. (a string)

---Whom the person at the keys is; at most one. Without it the camera flies.
---@param fields gnomon.player
---@return gnomon.player
function g.player(fields) end

---What the designer accepts for the whole level.
---@class (exact) gnomon.budget
---@field error_px? number Accepted displacement of shadow edges. Small values ask for dear techniques; over about 4 edges are seen to be wrong. Where nobody says, the picker takes 1, and 0.25 for heroes. (0 to 1000 px)
---@field shadow_ms? number Predicted time of all shadow work in a frame. Tight budgets give up accuracy where it buys most time; without it accuracy alone decides. (more than 0 and at most 1000 ms)

---What a designer asks of shadows.
---@class (exact) gnomon.shadow
---@field technique? "auto"|"none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced" The technique to use whatever it costs; "auto" leaves the choice to the picker. (one of "auto", "none", "blob", "planar", "shadow_texture", "volume", "cascaded_map", "spot_map", "cube_map", "traced")
---@field never? "none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced"|("none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced")[] Techniques that must not be picked; with too many of them nothing fits the budget. (one or a list of "none", "blob", "planar", "shadow_texture", "volume", "cascaded_map", "spot_map", "cube_map", "traced")
---@field error_px? number Accepted displacement of shadow edges. Small values ask for dear techniques; over about 4 edges are seen to be wrong. (0 to 1000 px)
---@field map_size? integer Texels per side of shadow maps. Too few give blocky edges, too many cost memory and time. (a whole number, 16 to 16384 texels)
---@field filter? "nearest"|"bilinear"|"pcf"|"pcss" How shadow maps are looked up: hard and cheap first, soft and dear last. (one of "nearest", "bilinear", "pcf", "pcss")
---@field samples? integer Points on the light that soft techniques try. Few show as bands, many cost time. (a whole number, 1 to 1024)
---@field cascades? integer Maps that share the view of a sun. One is coarse near the camera, four cost four passes. (a whole number, 1 to 4)
---@field proxy? integer How far volumes simplify heroes for what is not near them. 0 keeps every edge, 3 is cheapest and coarsest. (a whole number, 0 to 3)
---@field way? "geometry"|"box"|"boxes"|"plateau"|"texture" How planar shadows are made: from the casters themselves, from boxes in their place, with a soft skirt, or kept in a texture. Without it the cheapest that is right enough. (one of "geometry", "box", "boxes", "plateau", "texture")
---@field refresh? integer Frames that a shadow map or texture serves before it is drawn anew. 1 follows every motion; with more, shadows lag behind what moves. (a whole number, 1 to 1000 frames)

---What a designer asks of the shadows of one light.
---@class (exact) gnomon.light_shadow
---@field casts? boolean False lets the light through everything; it costs nothing then. (true or false; default true)
---@field technique? "auto"|"none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced" The technique to use whatever it costs; "auto" leaves the choice to the picker. (one of "auto", "none", "blob", "planar", "shadow_texture", "volume", "cascaded_map", "spot_map", "cube_map", "traced")
---@field never? "none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced"|("none"|"blob"|"planar"|"shadow_texture"|"volume"|"cascaded_map"|"spot_map"|"cube_map"|"traced")[] Techniques that must not be picked; with too many of them nothing fits the budget. (one or a list of "none", "blob", "planar", "shadow_texture", "volume", "cascaded_map", "spot_map", "cube_map", "traced")
---@field error_px? number Accepted displacement of shadow edges. Small values ask for dear techniques; over about 4 edges are seen to be wrong. (0 to 1000 px)
---@field map_size? integer Texels per side of shadow maps. Too few give blocky edges, too many cost memory and time. (a whole number, 16 to 16384 texels)
---@field filter? "nearest"|"bilinear"|"pcf"|"pcss" How shadow maps are looked up: hard and cheap first, soft and dear last. (one of "nearest", "bilinear", "pcf", "pcss")
---@field samples? integer Points on the light that soft techniques try. Few show as bands, many cost time. (a whole number, 1 to 1024)
---@field cascades? integer Maps that share the view of a sun. One is coarse near the camera, four cost four passes. (a whole number, 1 to 4)
---@field proxy? integer How far volumes simplify heroes for what is not near them. 0 keeps every edge, 3 is cheapest and coarsest. (a whole number, 0 to 3)
---@field way? "geometry"|"box"|"boxes"|"plateau"|"texture" How planar shadows are made: from the casters themselves, from boxes in their place, with a soft skirt, or kept in a texture. Without it the cheapest that is right enough. (one of "geometry", "box", "boxes", "plateau", "texture")
---@field refresh? integer Frames that a shadow map or texture serves before it is drawn anew. 1 follows every motion; with more, shadows lag behind what moves. (a whole number, 1 to 1000 frames)

---Something in a running level, found by its name.
---@class (exact) gnomon.handle
---@field name string What it is called; cannot be set.
---@field direction number[] As of g.sun.
---@field illuminance number As of g.sun.
---@field color number[] As of g.sun.
---@field on boolean As of g.sun.
---@field position number[] As of g.spot.
---@field intensity number As of g.spot.
---@field path_speed number As of g.model.
---@field rotation number[] As of g.model.
---@field animation_speed number As of g.model.

---The world of a running level; there is none before on_update is called.
---@class (exact) gnomon.world
---@field time number Seconds since the level began.
local world = {}

---What is called by a name; an error when nothing is.
---@param name string
---@return gnomon.handle
function world:find(name) end

g.world = world

---A linear colour from sRGB: srgb("#ff8800") or srgb(255, 136, 0).
---@param red string|number
---@param green? number
---@param blue? number
---@return number[]
function g.srgb(red, green, blue) end

return g
