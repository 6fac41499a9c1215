/**
 * No file and no folder imports, by whatever way, what imports it: one can be understood, tested and moved without the
 * other. Types count: who needs a type knows its owner. Where a lower folder needs something of a higher one, it says in
 * an interface of its own what that is. Circles of folders are found by `scripts/lib/folder-circles.mjs`, which takes a
 * folder with all that is in it.
 */
const comment =
  'Move what both need to a folder below, or let the lower one say in an interface what it needs.';

/** Folders of the frontend, line by line: each imports those of the lines above it, see its README. */
const FRONTEND = [
  ['context'],
  ['styles', 'theme', 'patterns', 'connection', 'formats', 'files', 'json', 'players', 'pad'],
  ['ui', 'locations'],
  ['page', 'marks', 'message-form', 'tab-node', 'install', 'asset-sets', 'load-charts'],
  ['topics', 'sessions'],
  ['clients', 'bridges', 'devices', 'modules', 'publish', 'calls', 'performance'],
  ['graph', 'joining'],
  ['session-pages', 'recordings', 'learn', 'settings', 'out-of-reach'],
  ['examples', 'party', 'studies'],
  ['home', 'markers', 'shell'],
];

/** Folders of the core of the client, likewise. */
const CLIENT = [
  ['ports'],
  ['callbacks'],
  ['time'],
  ['connection'],
  ['services', 'subscriptions', 'publishing'],
  ['devices'],
  ['client'],
];

/** Rules for folders below `root`: each imports those of the lines above its own. */
function inOrder(name, root, lines) {
  const inFolders = (folders) => `^${root}/(${folders.join('|')})/`;
  const rules = lines.flatMap((line, index) =>
    line.map((folder) => ({
      name: `${name}: ${folder}`,
      comment: 'Move what both need up in the list of this file, to a line that both may import.',
      severity: 'error',
      from: { path: inFolders([folder]) },
      to: { path: `^${root}/`, pathNot: inFolders([folder, ...lines.slice(0, index).flat()]) },
    })),
  );
  rules.push({
    name: `${name}: a folder that is not in the list`,
    comment: 'Add it to its line of the list in this file.',
    severity: 'error',
    from: { path: `^${root}/[^/]+/`, pathNot: inFolders(lines.flat()) },
    to: { path: `^${root}/` },
  });
  return rules;
}

export default {
  forbidden: [
    { name: 'no-circle', comment, severity: 'error', from: {}, to: { circular: true } },
    ...inOrder('order-of-the-frontend', 'apps/frontend/src', FRONTEND),
    ...inOrder('order-of-the-client', 'packages/client-web/src/core', CLIENT),
    {
      name: 'model-without-a-page',
      comment: 'The model of graphs is pure: give it what it needs as a parameter.',
      severity: 'error',
      from: { path: '^apps/frontend/src/graph/model/' },
      to: { path: String.raw`\.vue$|/node_modules/(vue|vue-router|@vueuse/[^/]+|reka-ui|rete)/` },
    },
    {
      name: 'name-of-composables',
      comment: 'Call the file as its composable: useThing.ts.',
      severity: 'error',
      from: {},
      to: { path: '/use-[^/]*$', pathNot: 'node_modules' },
    },
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    // Tests may know everything around what they test.
    exclude: { path: String.raw`\.test\.ts$|/dist/` },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.base.json' },
    enhancedResolveOptions: { extensions: ['.ts', '.js', '.vue'] },
  },
};
