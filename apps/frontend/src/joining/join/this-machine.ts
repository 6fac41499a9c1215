/** Whether this page was opened by a name that means the master's own machine. [AC-1] */
export function isThisMachine(hostname = location.hostname): boolean {
  return /^((.*\.)?localhost|127\..*|\[::1\])$/.test(hostname);
}
