import { fileURLToPath } from 'node:url';
import { ConfigError } from './adapters/config/config-error.ts';
import { KNOWN_MODELS } from './adapters/models/catalogue.ts';
import { runModels } from './adapters/models/model-program.ts';

const abort = new AbortController();
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) {
  process.on(signal, () => abort.abort());
}
// The script that started this program is gone.
process.on('disconnect', () => abort.abort());
process.channel?.unref();
try {
  process.exitCode = await runModels(process.argv.slice(2), {
    models: KNOWN_MODELS,
    // From src as well as from dist.
    assetsFolder: fileURLToPath(new URL('../../../packages/vision/dist/assets', import.meta.url)),
    env: process.env,
    cwd: process.cwd(),
    signal: abort.signal,
    isTerminal: process.stdout.isTTY,
    write: (text) => void process.stdout.write(text),
    writeError: (text) => void process.stderr.write(text),
    nowMs: () => performance.now(),
  });
} catch (error) {
  if (!(error instanceof ConfigError)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 1;
}
