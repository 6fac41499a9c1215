/** How a process ended, in words. */
export function describeEnd(code: number | null, signal: NodeJS.Signals | null): string {
  if (signal === 'SIGKILL') {
    return 'ended by SIGKILL, from a user or from a system without free memory (see dmesg)';
  }
  if (signal === 'SIGABRT') return 'ended by SIGABRT: its heap was full, or it gave itself up';
  return signal === null ? `ended with ${code}` : `ended by ${signal}`;
}
