// Loaded into Node with `--import`: a unit test that starts a process or a thread, or listens on a socket, fails.
// Sockets of native code (ZeroMQ) are not seen.
import childProcess from 'node:child_process';
import dgram from 'node:dgram';
import { syncBuiltinESMExports } from 'node:module';
import net from 'node:net';
import workerThreads from 'node:worker_threads';

/** esbuild compiles in a process of its own, which holds nothing that a test could depend on. */
const COMPILER = /esbuild/;

/**
 * @param {Record<string, any>} owner
 * @param {string} name
 * @param {string} does for the error
 */
function forbid(owner, name, does) {
  /** @param {any[]} args */
  const check = (args) => {
    // Only workers of Vitest run tests; the process that started them builds what they need.
    if (process.env.VITEST_POOL_ID === undefined) return;
    if (COMPILER.test(args[0]?.file ?? args[0])) return;
    throw new Error(
      `A unit test ${does}. Name its file *.process.test.ts (CONTRIBUTING.md, “Tests”).`,
    );
  };
  owner[name] = new Proxy(owner[name], {
    apply(original, self, args) {
      check(args);
      return Reflect.apply(original, self, args);
    },
    construct(original, args, newTarget) {
      check(args);
      return Reflect.construct(original, args, newTarget);
    },
  });
}

// All functions that do not wait start their process with this method.
forbid(childProcess.ChildProcess.prototype, 'spawn', 'starts a process');
for (const name of ['execFileSync', 'execSync', 'spawnSync']) {
  forbid(childProcess, name, 'starts a process');
}
forbid(workerThreads, 'Worker', 'starts a thread');
forbid(net.Server.prototype, 'listen', 'listens on a socket');
forbid(dgram.Socket.prototype, 'bind', 'binds a UDP socket');
syncBuiltinESMExports();
