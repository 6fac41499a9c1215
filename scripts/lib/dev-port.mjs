import { createServer } from 'node:net';

/**
 * The port the master of `npm run dev` is to use. Vite has to know it before the master runs, so
 * "any free port" is decided here.
 *
 * @param {string[]} flags flags for the master; `--port` is taken out
 * @returns {Promise<number>}
 */
export async function choosePort(flags) {
  const at = flags.findIndex((flag) => flag === '--port' || flag.startsWith('--port='));
  let wanted = process.env.UBII_PORT ?? '8080';
  if (at >= 0) {
    const [flag, value = flags[at + 1] ?? ''] = flags[at].split('=');
    flags.splice(at, flag === flags[at] ? 2 : 1);
    wanted = value;
  }
  return Number(wanted) === 0 ? freePort(0) : Number(wanted);
}

/** @param {number} wanted @returns {Promise<number>} `wanted` when it is free, else any other */
export function freePort(wanted) {
  return new Promise((resolve) => {
    const server = createServer();
    server.once('error', () => resolve(freePort(0)));
    server.listen(wanted, () => {
      const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });
}

/**
 * Whether the flags let other machines in.
 * @param {readonly string[]} flags
 */
export function isOnLan(flags) {
  const at = flags.findLastIndex((flag) => flag === '--lan' || flag.startsWith('--lan='));
  if (at < 0) return false;
  const value = flags[at]?.split('=')[1] ?? flags[at + 1] ?? '';
  return !/^(off|false|no|0)$/i.test(value);
}
