import { sandboxWorkersPlugin } from '@ubii/pm-sandbox/build';
import vue from '@vitejs/plugin-vue';
import { defineConfig } from 'vite';
import { licencesPlugins } from '../../scripts/lib/licences.mjs';
import { firstLoadPlugin } from './first-load-plugin.js';
import { learnReferencePlugin } from './learn-reference-plugin.js';
import { serviceWorkerPlugin } from './service-worker-plugin.js';

/** URL of the master for `npm run dev`; the built frontend is served by the master itself. */
const masterUrl = process.env.UBII_DEV_MASTER_URL ?? 'http://127.0.0.1:8080';

const licences = licencesPlugins();

/**
 * The master takes what comes from this machine for its operator: it is told when somebody else asked. [AC-1]
 *
 * @param {{ ws?: boolean }} options
 */
function passOn(options) {
  /** @type {(outgoing: import('node:http').ClientRequest, incoming: import('node:http').IncomingMessage) => void} */
  const tell = (outgoing, { socket }) => {
    const address = socket.remoteAddress ?? 'unknown';
    const isHere = /^(::ffff:)?127\.|^::1$/.test(address);
    if (!isHere) outgoing.setHeader('x-forwarded-for', address);
  };
  return {
    target: masterUrl,
    ...options,
    /** @param {import('vite').HttpProxy.Server} proxy */
    configure(proxy) {
      proxy.on('proxyReq', tell);
      proxy.on('proxyReqWs', tell);
    },
  };
}

export default defineConfig({
  plugins: [
    vue(),
    sandboxWorkersPlugin(),
    learnReferencePlugin(),
    serviceWorkerPlugin(),
    licences.plugin,
    firstLoadPlugin(),
  ],
  build: {
    // The newest syntax every browser of the last years runs; Lightning CSS lowers light-dark() to it.
    target: ['chrome105', 'firefox110', 'safari16.0'],
    assetsInlineLimit: 0,
    reportCompressedSize: true,
    rolldownOptions: {
      output: {
        codeSplitting: {
          groups: [
            // Examples shows all of them; each file has headers of 1.4 kB.
            {
              name: 'examples',
              test: /\/src\/examples\/([^/]+\/\w+Thumbnail|ExampleRow)\.vue/,
              includeDependenciesRecursively: false,
            },
            // The living session of Home, in one file in place of seven; other pages use parts of it.
            {
              name: 'living',
              test: /\/src\/(devices\/(useDevice|useFrontTab|front-tab|device-refusal)|sessions\/own\/|tab-node\/useTabNode|pad\/|topics\/names\/(useShortTopic|useFindPublisher|topic-path))/,
              minShareCount: 2,
              includeDependenciesRecursively: false,
            },
            // Two small files that connect a phone would have headers twice.
            {
              name: 'connect-phone',
              test: /\/src\/joining\/connect-phone\/(use(Grants|ConnectPhone|Lan)|grant-(choices|secrets)|open-phone|NoNetworkHelp)/,
              minShareCount: 2,
              includeDependenciesRecursively: false,
            },
            // Every page uses these. Pages share some hundred small modules; each as a file of its own is a request of its own.
            {
              name: 'proto',
              // Not the text of a file, which only the module editor has
              test: /packages\/(proto\/src|client-web\/src\/core)\/[^?]*$/,
              minShareCount: 3,
              includeDependenciesRecursively: false,
            },
            {
              name: 'shared',
              test: /@lucide|\/src\/(formats(?!\/picture-bitmap)|locations|ui\/readouts|ui\/tooltip|connection|context)\/|\/src\/ui\/Ui(EmptyState|CopyButton|Readout|StateMark|Avatar|Sparkline|Tooltip|Button)\.vue|\/src\/(page\/(shell|recent)|home\/in-words|shell\/(pages|shortcuts)|marks\/useMarks|players\/(player-identity|PlayerToken|outlines)|joining\/(join\/(join-words|this-machine|AdminNeeded)|connect-phone\/addresses)|ui\/keys\/single-key|ui\/toasts\/toasts|graph\/editor\/templates\/(while-used|own-pointer)|ui\/charts\/line-path|clients\/model\/client-facts|devices\/(keyboard-mouse\/held-keys|pointer-topic)|sessions\/(list\/session-rows|live\/session-totals|state\/session-state|useStoredSessions)|patterns\/pattern-source)|packages\/patterns\/src\/(glob|remembered|pattern-source)|packages\/(timing|words)\/src\/|@vueuse|vue-router|vite\/preload-helper|plugin-vue:export-helper/,
              minShareCount: 2,
              includeDependenciesRecursively: false,
            },
          ],
        },
      },
    },
  },
  worker: { format: 'es', plugins: () => [licences.workerPlugin()] },
  server: {
    proxy: {
      '/services': passOn({}),
      // The page of a recording has the same path as its file, without the ending.
      '^/recordings/[^/]+\\.mcap$': passOn({}),
      '/asset-sets': passOn({}),
      '/sdk': passOn({}),
      '/health': passOn({}),
      '/metrics': passOn({}),
      '/topicdata': passOn({ ws: true }),
    },
  },
  test: {
    // A DOM takes a quarter of a second a file: tests that need one begin with `@vitest-environment happy-dom`.
    environment: 'node',
    // Else style sheets read as text are empty (styles/tokens.test.ts)
    css: true,
    include: ['src/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Modules that a test loads late take seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
    expect: { poll: { timeout: 30_000 } },
  },
});
