//! The language of what the command line says: as asked for, else as the system has it; English stays as it was.

use super::program::{call, program, said};

#[test]
fn a_run_and_a_check_are_in_the_language_that_is_asked_for() {
    for args in [["--lang", "ja", "check", "deck-30m"], ["check", "deck-30m", "--lang", "ja"]] {
        let check = call(&args);
        assert_eq!(check.status, Some(0), "{args:?}: {}", check.err);
        for words in ["立体、重力加速度", "地動：", "条件 (6)", "摩擦則はリターンマッピング"]
        {
            assert!(check.out.contains(words), "{args:?}: {words}: {}", check.out);
        }
    }
    let run = call(&["run", "skew45-abutment", "--until", "1", "--lang=ja"]);
    for words in ["最大変位", "最大接触力", "衝突", "収支の残差"] {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    let digest = |out: &str| out.lines().last().and_then(|line| line.split(' ').next_back()).map(str::to_owned);
    let english = call(&["run", "skew45-abutment", "--until", "1"]);
    assert_eq!(digest(&run.out), digest(&english.out), "the answer is the same");
    assert!(english.out.contains("largest displacement"), "{}", english.out);
}

#[test]
fn help_is_in_the_language_that_is_asked_for() {
    for args in [["run", "--help", "--lang", "ja"], ["--lang", "ja", "run", "-h"], ["help", "run", "--lang", "ja"]] {
        let help = call(&args);
        assert_eq!(help.status, Some(0), "{args:?}: {}", help.err);
        for words in ["使い方：", "オプション", "要約を表示し、表をフォルダーに書く", "--digest"]
        {
            assert!(help.out.contains(words), "{args:?}: {words}: {}", help.out);
        }
    }
    assert!(call(&["run", "--help"]).out.contains("Usage: girderbench run"), "English as it stands with the flags");
}

#[test]
fn the_systems_language_is_spoken_where_none_is_asked_for() {
    let of = |locale: &str| {
        let mut command = program();
        command.env("LC_ALL", locale).args(["check", "skew45-abutment", "--set", "girder.deck.mass_kg=-1"]);
        said(&command.output().expect("the program starts"))
    };
    let (english, other, japanese) = (of("C"), of("fr_FR.UTF-8"), of("ja_JP.UTF-8"));
    assert_eq!(english.err, other.err, "English where the system's is none of ours");
    let line = "error: skew45-abutment: girder.deck.mass_kg: found -1; give a number greater than 0\n";
    assert!(english.err.ends_with(line) || english.err.contains("give a number greater than 0"), "{}", english.err);
    assert!(japanese.err.contains("0 より大きい数を与える"), "{}", japanese.err);
    assert_eq!((english.status, japanese.status), (Some(2), Some(2)), "the same status");
}

#[test]
fn a_scene_that_is_wrong_in_many_ways_is_complained_about_in_japanese() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("broken.toml");
    let text = "format = 1\nname = \"x\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\n\
                thickness_m = 1.5\nmass_kg = 6e5\nskew_deg = 200.0\nbearings = { frequency_hz = 0.8, damping_ratio = 0.1 }\n\
                [[abutment]]\nname = \"deck\"\nfaces = \"nobody\"\n[contact]\nmu_static = 0.1\nmu_kinetic = 0.3\n";
    std::fs::write(&scene, text).expect("written");
    let said = call(&["check", scene.to_str().expect("UTF-8"), "--lang", "ja"]);
    assert_eq!(said.status, Some(2), "{}", said.out);
    let lines: Vec<&str> = said.err.lines().collect();
    assert!(lines.len() > 3, "every complaint: {}", said.err);
    for line in lines {
        assert!(line.contains("。") && !line.contains("found") && !line.contains("give"), "{line}");
        assert!(!line.contains(['\u{2068}', '\u{2069}']), "no marks around values: {line}");
    }
}

#[test]
fn what_the_other_commands_print_is_in_the_language_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let decay: Vec<String> = (0..200)
        .map(|n| 0.01 * f64::from(n))
        .map(|t| format!("{t},{}\n", (-0.8 * t).exp() * (15.0 * t).cos() + 1e-3 * (97.0 * t).sin()))
        .collect();
    let decay = decay.concat();
    std::fs::write(path("decay.csv"), format!("t_s,x_mm\n{decay}")).expect("written");
    std::fs::write(path("wrong.csv"), "t_s,x_mm\n0,1\n1,x\n").expect("written");
    let (decay, wrong, laws) = (path("decay.csv"), path("wrong.csv"), path("laws"));
    let angle = ["--set", "motion.angle_deg=10"];
    for (args, words) in [
        (vec!["compare", "skew45-abutment", "straight-abutment"], ["両方にある時刻", "イベント：A に", "で分かれる"]),
        (vec!["identify", &decay], ["固有振動数 f", "静止：自由減衰", "目盛の零点"]),
        (vec!["identify", &wrong], ["3 行目：`x`", "2 列目は有限の数", ""]),
        (vec!["study", "laws", "--out", &laws], ["に書いた", "ファイル", ""]),
        (vec!["study", "accuracy", "nothing", "--out", &laws], ["のどれでもない", "この中から与える", ""]),
        (vec!["run", "deck-30m", "--until", "0.1"], ["道示 V、S_E ", "道示 V、S_Eθ", "必要"]),
        (
            vec!["run", "viaduct-5", "--set", "model.kind=impact"],
            ["衝撃モデルは装置、橋脚、降伏・滑り", "扱わない", "model.kind"],
        ),
        (
            vec!["sweep", "skew45-abutment", "--vary", "motion.angle_deg=0,45", "--measure", "foo", "--out", &laws],
            ["その名前の量はない", "max_rotation", ""],
        ),
        ([&["check", "skew45-abutment"], &angle[..]].concat(), ["入力角 10°", "正弦波", ""]),
    ] {
        let said = call(&[&args[..], &["--lang", "ja"]].concat());
        let all = format!("{}{}", said.out, said.err);
        assert!(words.iter().all(|words| all.contains(words)), "{args:?}: {all}");
        for english in ["instants", "displacements in", " rows", "written", "give ", "lower its", "measures:"] {
            assert!(!all.contains(english), "{args:?}: {english}: {all}");
        }
    }
}
