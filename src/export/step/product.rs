//! What surrounds the geometry: header, units and the product that has the shape.

use super::configuration::Versioned;
use super::entities::{Entities, Id, string};
use super::shell::Shape;
use super::{Context, StepSchema};
use crate::number::Unit;

/// The header: its records are filled and the time stamp is fixed, so that equal surfaces give
/// equal files.
pub(super) fn header(context: &Context) -> String {
    let file = string(&format!("{}.step", context.file_stem()));
    let program = concat!("'sweepc ", env!("CARGO_PKG_VERSION"), "'");
    format!(
        "HEADER;\n\
         FILE_DESCRIPTION(('swept surface as a rational B-spline'),'2;1');\n\
         FILE_NAME({file},'1970-01-01T00:00:00',('unknown'),('unknown'),{program},{program},'none');\n\
         FILE_SCHEMA(('{}'));\n\
         ENDSEC;\n",
        context.step_schema.identifier()
    )
}

/// The unit of length as an entity.
fn write_unit(unit: Unit, entities: &mut Entities) -> Id {
    let length = "LENGTH_UNIT()".to_owned();
    let mut metric = |prefix: &str| {
        let si = format!("SI_UNIT({prefix},.METRE.)");
        entities.add_complex(&mut [length.clone(), "NAMED_UNIT(*)".to_owned(), si])
    };
    match unit {
        Unit::Millimetre => metric(".MILLI."),
        Unit::Centimetre => metric(".CENTI."),
        Unit::Metre => metric("$"),
        Unit::Inch => {
            let base = metric(".MILLI.");
            let factor = entities.add(&format!(
                "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{base})"
            ));
            let dimensions = entities.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
            entities.add_complex(&mut [
                length.clone(),
                format!("NAMED_UNIT({dimensions})"),
                format!("CONVERSION_BASED_UNIT('INCH',{factor})"),
            ])
        }
    }
}

/// The units and the uncertainty in which the geometry is meant.
fn write_geometric_context(unit: Unit, entities: &mut Entities) -> Id {
    let length = write_unit(unit, entities);
    let mut si = |kind: &str, name: &str| {
        let parts = [
            format!("{kind}()"),
            "NAMED_UNIT(*)".to_owned(),
            format!("SI_UNIT($,.{name}.)"),
        ];
        entities.add_complex(&mut parts.clone())
    };
    let angle = si("PLANE_ANGLE_UNIT", "RADIAN");
    let solid = si("SOLID_ANGLE_UNIT", "STERADIAN");
    let uncertainty = entities.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{length},'distance_accuracy_value','points closer than this coincide')"
    ));
    entities.add_complex(&mut [
        "GEOMETRIC_REPRESENTATION_CONTEXT(3)".to_owned(),
        format!("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))"),
        format!("GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))"),
        "REPRESENTATION_CONTEXT('','3D')".to_owned(),
    ])
}

/// The category of the product: a part, which AP203 divides further.
fn write_category(product: Id, schema: StepSchema, entities: &mut Entities) {
    let mut of_product = |name: &str| {
        entities.add(&format!(
            "PRODUCT_RELATED_PRODUCT_CATEGORY('{name}','',({product}))"
        ))
    };
    if schema != StepSchema::Ap203 {
        of_product("part");
        return;
    }
    let detail = of_product("detail");
    let part = entities.add("PRODUCT_CATEGORY('part','')");
    entities.add(&format!(
        "PRODUCT_CATEGORY_RELATIONSHIP('','',{part},{detail})"
    ));
}

/// The product whose shape it is; without it readers find nothing.
pub(super) fn write(shape: &Shape, context: &Context, entities: &mut Entities) {
    let name = string(context.name());
    let geometry = write_geometric_context(context.unit, entities);
    let Shape {
        representation,
        item,
    } = shape;
    let representation = entities.add(&format!("{representation}({name},({item}),{geometry})"));
    let (what, schema, year) = context.step_schema.application();
    let [of_product, of_definition, of_version, source] = context.step_schema.product_entities();
    let application = entities.add(&format!("APPLICATION_CONTEXT('{what}')"));
    entities.add(&format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','{schema}',{year},{application})"
    ));
    let product_context = entities.add(&format!("{of_product}('',{application},'mechanical')"));
    let product = entities.add(&format!("PRODUCT({name},{name},'',({product_context}))"));
    write_category(product, context.step_schema, entities);
    let formation = entities.add(&format!("{of_version}('','',{product}{source})"));
    let stage = entities.add(&format!(
        "{of_definition}('part definition',{application},'design')"
    ));
    let definition = entities.add(&format!("PRODUCT_DEFINITION('','',{formation},{stage})"));
    if context.step_schema == StepSchema::Ap203 {
        let versioned = Versioned {
            product,
            formation,
            definition,
        };
        versioned.write_configuration(entities);
    }
    let property = entities.add(&format!("PRODUCT_DEFINITION_SHAPE('','',{definition})"));
    entities.add(&format!(
        "SHAPE_DEFINITION_REPRESENTATION({property},{representation})"
    ));
}
