import { sandboxWorkersPlugin } from '@ubii/pm-sandbox/build';
import vue from '@vitejs/plugin-vue';
import { defineConfig } from 'vite';
import { licencesPlugins } from '../../scripts/lib/licences.mjs';

/** Where `npm run dev` finds a master; the built frontend is served by the master itself. */
const masterUrl = process.env.UBII_DEV_MASTER_URL ?? 'http://127.0.0.1:8080';

const licences = licencesPlugins();

export default defineConfig({
  plugins: [vue(), sandboxWorkersPlugin(), licences.plugin],
  build: {
    // The newest syntax every browser of the last years runs; Lightning CSS lowers light-dark() to it.
    target: ['chrome105', 'firefox110', 'safari16.0'],
    assetsInlineLimit: 0,
    reportCompressedSize: true,
  },
  worker: { format: 'es', plugins: () => [licences.workerPlugin()] },
  server: {
    proxy: {
      '/services': masterUrl,
      '/health': masterUrl,
      '/metrics': masterUrl,
      '/topicdata': { target: masterUrl, ws: true },
    },
  },
  test: {
    environment: 'happy-dom',
    // Else style sheets read as text are empty (styles/tokens.test.ts)
    css: true,
    include: ['src/**/*.test.ts'],
  },
});
