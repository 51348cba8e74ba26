use super::entities::{Entities, Id, list};

/// The entities of a product that configuration management asks for.
pub(super) struct Versioned {
    pub(super) product: Id,
    /// The version of the product.
    pub(super) formation: Id,
    pub(super) definition: Id,
}

impl Versioned {
    /// What every version has by AP203: who made and owns it, its security classification, its
    /// approval, and when. Nobody has approved it, and nobody is named.
    pub(super) fn write_configuration(&self, entities: &mut Entities) {
        let Self {
            product,
            formation,
            definition,
        } = *self;
        let level = entities.add("SECURITY_CLASSIFICATION_LEVEL('unclassified')");
        let classification = entities.add(&format!("SECURITY_CLASSIFICATION('','',{level})"));
        entities.add(&format!(
            "CC_DESIGN_SECURITY_CLASSIFICATION({classification},({formation}))"
        ));
        let person = write_person(entities);
        for (role, items) in [
            ("creator", vec![formation, definition]),
            ("design_owner", vec![product]),
            ("design_supplier", vec![formation]),
            ("classification_officer", vec![classification]),
        ] {
            let role = entities.add(&format!("PERSON_AND_ORGANIZATION_ROLE('{role}')"));
            entities.add(&format!(
                "CC_DESIGN_PERSON_AND_ORGANIZATION_ASSIGNMENT({person},{role},{})",
                list(items)
            ));
        }
        let date = write_date(entities);
        for (role, item) in [
            ("creation_date", definition),
            ("classification_date", classification),
        ] {
            let role = entities.add(&format!("DATE_TIME_ROLE('{role}')"));
            entities.add(&format!(
                "CC_DESIGN_DATE_AND_TIME_ASSIGNMENT({date},{role},({item}))"
            ));
        }
        let status = entities.add("APPROVAL_STATUS('not_yet_approved')");
        let approval = entities.add(&format!("APPROVAL({status},'')"));
        let role = entities.add("APPROVAL_ROLE('approver')");
        entities.add(&format!(
            "APPROVAL_PERSON_ORGANIZATION({person},{approval},{role})"
        ));
        entities.add(&format!("APPROVAL_DATE_TIME({date},{approval})"));
        let items = list([formation, definition, classification]);
        entities.add(&format!("CC_DESIGN_APPROVAL({approval},{items})"));
    }
}

/// Nobody in particular.
fn write_person(entities: &mut Entities) -> Id {
    let person = entities.add("PERSON('unknown','unknown',$,$,$,$)");
    let organization = entities.add("ORGANIZATION('unknown','unknown','')");
    entities.add(&format!("PERSON_AND_ORGANIZATION({person},{organization})"))
}

/// The time stamp of the header.
fn write_date(entities: &mut Entities) -> Id {
    let date = entities.add("CALENDAR_DATE(1970,1,1)");
    let zone = entities.add("COORDINATED_UNIVERSAL_TIME_OFFSET(0,0,.AHEAD.)");
    let time = entities.add(&format!("LOCAL_TIME(0,0,0.,{zone})"));
    entities.add(&format!("DATE_AND_TIME({date},{time})"))
}
