//! Methods of iterators, options, collections, text and numbers. A call of one of them on a
//! receiver of unknown type reveals nothing about the crate's own types.

const METHODS: &str = "\
    abs all any append as_deref as_mut as_ref as_slice as_str borrow bytes ceil chain chars chunks clear \
    clone clone_from cloned cmp collect contains contains_key copied cos count cycle dedup div_ceil \
    drain ends_with entry enumerate eq err expect extend fill filter filter_map find find_map first \
    flat_map flatten floor flush fmt fold for_each from_fn get get_mut get_or hash insert inspect \
    into_iter into_keys into_values is_empty is_err is_finite is_nan is_none is_ok is_some iter iter_mut \
    join keys last len lines lock map map_err map_or map_while max max_by min min_by mul_add next \
    next_back nth ok or or_else parse partition peek pop position powf powi product push push_str read \
    recip remove repeat replace resize retain rev rotate_left round scan set sin sin_cos size_hint skip \
    skip_while sort span split split_at sqrt starts_with step_by sum swap swap_remove take take_while \
    tan then to_owned to_string to_vec trim truncate try_fold unwrap_or unzip values windows write \
    write_fmt write_str zip";

/// True if the standard library has a method of that name.
pub(crate) fn is_standard(method: &str) -> bool {
    METHODS.split_whitespace().any(|name| name == method)
}
