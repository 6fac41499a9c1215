import { ConfigError, readOptions } from '@ubii/program';
import type { Environment, ReadOptions } from '@ubii/program';

import { MASTER_PROGRAM } from './config.ts';
import type { Config, OPTIONS } from './config.ts';

/**
 * Reads the configuration.
 *
 * @param args command line without program and script
 * @throws ConfigError for an unknown flag or key and for an invalid value
 */
export function resolveConfig(args: readonly string[], env: Environment, cwd: string): Config {
  return createConfig(readOptions(MASTER_PROGRAM, args, env, cwd));
}

/** @throws ConfigError for options that contradict each other */
export function createConfig({ values, given }: ReadOptions<typeof OPTIONS>): Config {
  const config = { ...values, given };
  checkTogether(config);
  // Who says where to listen does not want all networks.
  return given.has('host') ? { ...config, lan: false } : config;
}

/** Checks combinations of options. */
function checkTogether(config: Config): void {
  if (config.lan && config.given.has('lan') && config.given.has('host')) {
    throw new ConfigError(
      `--lan listens on all networks and --host on "${config.host}" only. Remove one of them.`,
    );
  }
  if (config.trustLoopback && config.loopback === 'none') {
    throw new ConfigError(
      '--trust-loopback makes callers of this machine admins, and --loopback none gives them no access. Remove one of them.',
    );
  }
  if ((config.tlsCertificate === undefined) !== (config.tlsKey === undefined)) {
    throw new ConfigError(
      'A certificate and its key belong together: give both --tls-certificate and --tls-key, or neither.',
    );
  }
}
