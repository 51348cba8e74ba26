/// An application protocol of STEP: which products the geometry may belong to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum StepSchema {
    /// Configuration-controlled design, ISO 10303-203.
    Ap203,
    /// Automotive design, ISO 10303-214.
    #[default]
    Ap214,
    /// Managed model-based engineering, ISO 10303-242.
    Ap242,
}

impl StepSchema {
    /// The name of the schema in the header.
    pub(super) fn identifier(self) -> &'static str {
        match self {
            Self::Ap203 => "CONFIG_CONTROL_DESIGN",
            Self::Ap214 => "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }",
            Self::Ap242 => {
                "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }"
            }
        }
    }

    /// What the application is called, its schema, and the year of that.
    pub(super) fn application(self) -> (&'static str, &'static str, u32) {
        match self {
            Self::Ap203 => (
                "configuration controlled 3d designs of mechanical parts and assemblies",
                "config_control_design",
                1994,
            ),
            Self::Ap214 => ("automotive design", "automotive_design", 2000),
            Self::Ap242 => (
                "managed model based 3d engineering",
                "ap242_managed_model_based_3d_engineering",
                2013,
            ),
        }
    }

    /// The entities of the contexts of products and of their definitions, and of the version of a
    /// product with its last attributes.
    pub(super) fn product_entities(self) -> [&'static str; 4] {
        match self {
            Self::Ap203 => [
                "MECHANICAL_CONTEXT",
                "DESIGN_CONTEXT",
                "PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE",
                ",.NOT_KNOWN.",
            ],
            Self::Ap214 | Self::Ap242 => [
                "PRODUCT_CONTEXT",
                "PRODUCT_DEFINITION_CONTEXT",
                "PRODUCT_DEFINITION_FORMATION",
                "",
            ],
        }
    }
}
