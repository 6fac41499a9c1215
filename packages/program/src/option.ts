/** Invalid set-up. The message is for the person who started the program; it is printed without a stack. */
export class ConfigError extends Error {
  override readonly name = 'ConfigError';
}

/** One option of a program. */
export interface Option<T> {
  /**
   * Placeholder after the flag in the help. `undefined`: a switch without a value. In brackets, as `[on|off]`: a switch
   * whose value may be left out.
   */
  readonly placeholder: string | undefined;
  /** Default value. */
  readonly fallback: T;
  /** Shown in the help instead of the fallback. */
  readonly fallbackText?: string;
  /** Effect of the option, with its unit. */
  readonly description: string;
  /** Advice for an invalid value, without a full stop. Default: `Use <flag> <placeholder>`. */
  readonly hint?: string;
  /** Errors and descriptions do not show the value. Default: false */
  readonly isSecret?: boolean;
  /**
   * @param text as given on the command line, in the environment or in the file
   * @param baseDir folder that relative paths are relative to
   * @throws Error whose message is the expected value, to follow "must be"
   */
  parse(text: string, baseDir: string): T;
}

/** All options of a program, by name in camel case. */
export type OptionTable = Readonly<Record<string, Option<unknown>>>;

/** The values of all options. */
export type OptionValues<O extends OptionTable> = {
  readonly [N in keyof O]: O[N] extends Option<infer T> ? T : never;
};

/**
 * A program and its options. The flag, the environment variable and the key in the config file are made from the name
 * of an option: `dataDir` is `--data-dir`, `UBII_DATA_DIR` and `"dataDir"`. A flag has precedence over the environment,
 * the environment over the file, and the file over the fallback.
 */
export interface ProgramOptions<O extends OptionTable> {
  readonly options: O;
  /** The help above the options, with a line break at its end. */
  readonly about: string;
  /** The help below the options. */
  readonly notes?: string;
  /** Start of the environment variables, such as `UBII_`. Default: options are not read from the environment. */
  readonly environmentPrefix?: string;
  /** Name of the option with the path of a config file. Default: options are not read from a file. */
  readonly fileOption?: keyof O & string;
  /** Arguments that are no flags are accepted. Default: false */
  readonly takesWords?: boolean;
  /**
   * Checks combinations of options.
   *
   * @param given names of the options that are set
   * @throws ConfigError for options that contradict each other
   */
  check?(values: OptionValues<O>, given: ReadonlySet<keyof O & string>): void;
  /** Exit code after a `ConfigError`. Default: 1 */
  readonly errorExitCode?: number;
}

/** Returns the option; its type is checked where it is written. */
export function option<T>(entry: Option<T>): Option<T> {
  return entry;
}

/** `dataDir` -> `--data-dir` */
export function flagName(name: string): string {
  return `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
}

/** `UBII_`, `dataDir` -> `UBII_DATA_DIR` */
export function environmentName(prefix: string, name: string): string {
  return `${prefix}${name.replace(/[A-Z]/g, (letter) => `_${letter}`).toUpperCase()}`;
}
