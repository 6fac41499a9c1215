import type { Random } from '../random.ts';

/** Parameters of a scenario. */
export interface ScenarioOptions {
  /** Main file of a built master, and of a built node. */
  readonly program: string;
  readonly node: string;
  readonly random: Random;
  /** Number of faults; longer runs have more. */
  readonly times: number;
}

/** Result of a scenario. */
export interface Outcome {
  /** Requests that the master acknowledged, and that it refused or did not answer. */
  readonly acknowledged: number;
  readonly refused: number;
  /** Acknowledged changes that the master lost, in words; there may be none. */
  readonly losses: readonly string[];
  /** Time until everything was back, for each fault, milliseconds. */
  readonly backMs: readonly number[];
  /** Further observations. */
  readonly notes: readonly string[];
}

/** One kind of fault, injected several times during a workload. */
export interface Scenario {
  /** For `--only`. */
  readonly name: string;
  readonly about: string;
  /** Why it cannot be tried here; undefined: it can. */
  reasonAgainst?(): string | undefined;
  run(stage: ScenarioOptions): Promise<Outcome>;
}
