import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const ENTRY = fileURLToPath(new URL('src/out-of-reach/service-worker.ts', import.meta.url));

/**
 * Vite plugin: adds `/service-worker.js` to the build, in one file and under a name that stays, so that
 * browsers find the next one. There is none in development.
 *
 * @returns {import('vite').Plugin}
 */
export function serviceWorkerPlugin() {
  /** @type {import('vite').BuildOptions['target']} */
  let target;
  return {
    name: 'ubii-service-worker',
    apply: 'build',
    configResolved(config) {
      target = config.build.target;
    },
    async generateBundle() {
      const built = await build({
        configFile: false,
        logLevel: 'warn',
        build: {
          target,
          write: false,
          copyPublicDir: false,
          rollupOptions: { input: ENTRY, output: { format: 'iife' } },
        },
      });
      const [{ output }] = /** @type {[import('vite').Rollup.RollupOutput]} */ ([built].flat());
      this.emitFile({ type: 'asset', fileName: 'service-worker.js', source: output[0].code });
    },
  };
}
