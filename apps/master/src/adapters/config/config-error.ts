/** The set-up is not as it has to be: the message is one sentence for the person who started the master. */
export class ConfigError extends Error {
  override readonly name = 'ConfigError';
}
