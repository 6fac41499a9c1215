/** The text of an option that is set, its place, and the base folder of relative paths. */
export interface Given {
  readonly text: string;
  /** Such as `on the command line`. */
  readonly place: string;
  readonly baseDir: string;
}

/** Options that are set, by name. */
export type GivenOptions = ReadonlyMap<string, Given>;
