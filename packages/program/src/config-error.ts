/** Invalid set-up. The message is for the person who started the program; it is printed without a stack. */
export class ConfigError extends Error {
  override readonly name = 'ConfigError';
}
