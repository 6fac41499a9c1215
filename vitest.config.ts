import { availableParallelism } from 'node:os';
import { defineConfig, type TestProjectInlineConfiguration } from 'vitest/config';

/** Packages whose process tests run something that is built first, with the file that builds it. */
const BUILDS = new Map([
  ['apps/bridge', 'apps/bridge/test/build-programs.ts'],
  ['apps/node', 'apps/node/test/build-programs.ts'],
  ['packages/client-web', 'packages/client-web/test/build-package.ts'],
  ['packages/pm-sandbox', 'packages/pm-sandbox/test/build-worker.ts'],
  ['robustness', 'packages/harness/src/master/build-for-tests.ts'],
]);

/** Tests that start processes or threads, or listen on sockets. The configurations of their packages leave them out. */
function processTests(
  name: string,
  folder: string,
  others: Partial<TestProjectInlineConfiguration['test']>,
): TestProjectInlineConfiguration {
  return {
    test: {
      name,
      include: [`${folder}/{scripts,src,test}/**/*.process.test.ts`],
      // A process takes seconds on a busy machine; none waits for a time to pass.
      testTimeout: 120_000,
      hookTimeout: 120_000,
      expect: { poll: { timeout: 30_000 } },
      ...others,
    },
  };
}

export default defineConfig({
  test: {
    // Vitest leaves one core free, which is half of a machine with two.
    maxWorkers: Math.max(2, availableParallelism() - 1),
    projects: [
      ...['packages/*', 'apps/*', 'demos/*', 'benchmarks', 'robustness'],
      processTests('process', '{packages/*,apps/*,demos/*,benchmarks,robustness}', {
        exclude: [...BUILDS.keys()].map((folder) => `${folder}/**`),
      }),
      ...[...BUILDS].map(([folder, build]) =>
        processTests(`process ${folder}`, folder, { globalSetup: build }),
      ),
    ],
  },
});
