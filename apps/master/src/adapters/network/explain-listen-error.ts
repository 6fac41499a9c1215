import { ConfigError } from '@ubii/program';

/**
 * One sentence for a port that could not be had.
 *
 * @param option the flag that chose the port
 */
export function explainListenError(
  error: unknown,
  wanted: { readonly port: number; readonly host: string; readonly option: string },
): ConfigError {
  const { port, host, option } = wanted;
  const another =
    option === '--port'
      ? 'choose another with --port, where 0 takes any free one'
      : `choose others with ${option}, or none with ${option} off`;
  const { code, message } = error as NodeJS.ErrnoException;
  switch (code) {
    case 'EADDRINUSE':
      return new ConfigError(
        `Port ${port} (${option}) is used by another program: end that program, or ${another}.`,
      );
    case 'EACCES':
      return new ConfigError(
        `Port ${port} (${option}) is not open to this user: ports below 1024 often need an administrator; ${another}.`,
      );
    case 'EADDRNOTAVAIL':
    case 'ENOTFOUND':
    case 'EAI_AGAIN':
      return new ConfigError(
        `The host "${host}" (--host) is not an address of this machine: leave --host out, or use --lan to listen on all its networks.`,
      );
    default:
      return new ConfigError(`Port ${port} (${option}) cannot be opened: ${message}; ${another}.`);
  }
}
