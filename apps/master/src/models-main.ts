import { fileURLToPath } from 'node:url';
import { exitOnConfigError, onStopRequest } from '@ubii/program';
import { KNOWN_MODELS } from './adapters/models/catalogue.ts';
import { runModels } from './adapters/models/model-program.ts';

const abort = new AbortController();
onStopRequest(() => abort.abort());
await exitOnConfigError(async () => {
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
});
