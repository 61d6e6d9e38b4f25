//! Shares, and the environments that launchers create.

use std::string::{String, ToString};

use super::Shard;

/// Returns the shard of an environment, or the error message.
fn shard(variables: &[(&str, &str)]) -> Result<(u64, u64), String> {
    let variables = variables.iter().map(|(name, value)| (name.to_string(), value.to_string())).collect();
    let found = Shard::from_variables(&variables).map(|shard| (shard.index(), shard.count()));
    found.map_err(|error| error.to_string())
}

#[test]
fn launchers_determine_the_share() {
    assert_eq!(shard(&[]), Ok((0, 1)));
    assert_eq!(shard(&[("OMPI_COMM_WORLD_RANK", "2"), ("OMPI_COMM_WORLD_SIZE", "4")]), Ok((2, 4)));
    assert_eq!(shard(&[("PMI_RANK", "0"), ("PMI_SIZE", "3")]), Ok((0, 3)));
    assert_eq!(shard(&[("SLURM_PROCID", "5"), ("SLURM_STEP_NUM_TASKS", "6")]), Ok((5, 6)));
    assert_eq!(shard(&[("HQ_TASK_ID", "1"), ("LAGRANGE_SHARDS", "2")]), Ok((1, 2)));
    assert_eq!(shard(&[("LAGRANGE_SHARD", "3/8"), ("PMI_RANK", "0"), ("PMI_SIZE", "3")]), Ok((3, 8)));
}

#[test]
fn a_batch_script_is_one_process() {
    assert_eq!(shard(&[("SLURM_PROCID", "0"), ("SLURM_NTASKS", "6")]), Ok((0, 1)));
}

#[test]
fn tasks_of_an_array_start_several_processes() {
    let array = [
        ("SLURM_ARRAY_TASK_ID", "14"),
        ("SLURM_ARRAY_TASK_COUNT", "3"),
        ("SLURM_ARRAY_TASK_MIN", "10"),
        ("SLURM_ARRAY_TASK_STEP", "2"),
    ];
    assert_eq!(shard(&array), Ok((2, 3)));
    let ranks = [("OMPI_COMM_WORLD_RANK", "1"), ("OMPI_COMM_WORLD_SIZE", "4")];
    assert_eq!(shard(&[&array[..], &ranks].concat()), Ok((9, 12)));
}

/// Otherwise each process would compute everything.
#[test]
fn a_launcher_that_is_not_known_is_not_passed_over() {
    for place in [
        "PBS_ARRAY_INDEX",
        "PBS_ARRAYID",
        "SGE_TASK_ID",
        "LSB_JOBINDEX",
        "PMIX_RANK",
        "PALS_RANKID",
        "ALPS_APP_PE",
        "FLUX_TASK_RANK",
        "MV2_COMM_WORLD_RANK",
        "JSM_NAMESPACE_RANK",
        "OAR_ARRAY_INDEX",
        "_CONDOR_PROCNO",
        "AWS_BATCH_JOB_ARRAY_INDEX",
        "CLOUD_RUN_TASK_INDEX",
        "BATCH_TASK_INDEX",
        "JOB_COMPLETION_INDEX",
        "RANK",
    ] {
        let error = shard(&[("HOME", "/root"), (place, "3")]).expect_err("is not known");
        assert!(error.contains(&std::format!("{place}=`3`")) && error.contains("LAGRANGE_SHARD"), "{error}");
        assert_eq!(shard(&[(place, "3"), ("LAGRANGE_SHARD", "3/8")]), Ok((3, 8)));
        assert_eq!(shard(&[(place, "3"), ("PMI_RANK", "1"), ("PMI_SIZE", "3")]), Ok((1, 3)));
    }
    for (name, value) in [
        ("SGE_TASK_ID", "undefined"),
        ("LSB_JOBINDEX", "0"),
        ("FRANK", "1"),
        ("SLURM_LOCALID", "0"),
        ("PRANK_ID", "2"),
    ] {
        assert_eq!(shard(&[(name, value)]), Ok((0, 1)), "{name}");
    }
}

#[test]
fn mistakes_of_an_environment_are_reported() {
    let beyond = shard(&[("PMI_RANK", "3"), ("PMI_SIZE", "3")]).expect_err("is beyond");
    assert!(beyond.contains("no shard 3 of 3"), "{beyond}");
    let incomplete = shard(&[("HQ_TASK_ID", "1")]).expect_err("has no count");
    assert!(incomplete.contains("LAGRANGE_SHARDS is not set"), "{incomplete}");
    for (there, missing) in [
        ("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
        ("PMI_SIZE", "PMI_RANK"),
        ("SLURM_STEP_NUM_TASKS", "SLURM_PROCID"),
        ("LAGRANGE_SHARDS", "HQ_TASK_ID"),
    ] {
        let incomplete = shard(&[(there, "2")]).expect_err("is half of it");
        assert!(incomplete.contains(&std::format!("{missing} is not set")), "{incomplete}");
    }
    let text = shard(&[("PMI_RANK", "one"), ("PMI_SIZE", "3")]).expect_err("is text");
    assert!(text.contains("PMI_RANK=`one`"), "{text}");
    let array =
        ["SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_STEP"];
    let below =
        shard(&[(array[0], "1"), (array[1], "4"), (array[2], "2"), (array[3], "1")]).expect_err("is below");
    assert!(below.contains("SLURM_ARRAY_TASK_ID=`1`, which is below 2"), "{below}");
    let by_hand = shard(&[("LAGRANGE_SHARD", "3 of 8")]).expect_err("is text");
    assert!(by_hand.contains("of the form `3/8`"), "{by_hand}");
    assert!(shard(&[("LAGRANGE_SHARD", "0/0")]).is_err());
}

#[test]
fn shares_follow_each_other_and_are_everything() {
    for (number, count) in [(10, 3), (2, 5), (0, 2), (usize::MAX, 7)] {
        let mut end = 0;
        for index in 0..count {
            let share = Shard::of(index, count).share(number);
            assert_eq!(share.start, end);
            end = share.end;
        }
        assert_eq!(end, number);
    }
}
