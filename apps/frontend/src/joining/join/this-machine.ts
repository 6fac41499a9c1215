/** Whether this page was opened by a loopback hostname, on the master's own computer. [AC-1] */
export function isThisMachine(hostname = location.hostname): boolean {
  return /^((.*\.)?localhost|127\..*|\[::1\])$/.test(hostname);
}
