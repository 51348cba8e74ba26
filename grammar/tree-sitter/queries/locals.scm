; A construction has names of its own: its parameters, and those after `where`. All other names are
; those of the file.

(document) @local.scope
(construction_declaration) @local.scope

(param_declaration name: (name) @local.definition)
(let_declaration name: (name) @local.definition)
(profile_declaration name: (name) @local.definition)
(sweep_declaration name: (name) @local.definition)
(curve_declaration name: (name) @local.definition)
(surface_declaration name: (name) @local.definition)

(construction_declaration parameters: (parameters (name) @local.definition))
(binding name: (name) @local.definition)

(reference !qualifier name: (name) @local.reference)
(function !qualifier name: (name) @local.reference)
(_ qualifier: (name) @local.reference)
