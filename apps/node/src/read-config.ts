import { ConfigError, readOptions } from '@ubii/program';
import type { Environment, ReadOptions } from '@ubii/program';
import { NODE_PROGRAM } from './options.ts';
import type { Config, OPTIONS } from './options.ts';

/**
 * Reads the configuration.
 *
 * @param args arguments without program and script
 * @throws ConfigError for an unknown flag and for an invalid value
 */
export function readConfig(args: readonly string[], env: Environment, cwd: string): Config {
  return checkConfig(readOptions(NODE_PROGRAM, args, env, cwd));
}

/** @throws ConfigError for options that contradict each other */
export function checkConfig({ values, given }: ReadOptions<typeof OPTIONS>): Config {
  if (values.discover && given.has('master')) {
    throw new ConfigError(
      'The options --master and --discover both choose the master. Remove one of them.',
    );
  }
  if (values.join !== undefined && values.tokenFile !== undefined) {
    throw new ConfigError(
      'The options --join and --token-file both set the token. Remove one of them.',
    );
  }
  return values;
}
