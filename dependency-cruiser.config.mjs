/**
 * No file and no folder imports, by whatever way, what imports it: one can be understood, tested and moved without the
 * other. Types count: who needs a type knows its owner. Where a lower folder needs something of a higher one, it says in
 * an interface of its own what that is.
 */
const comment =
  'Move what both need to a folder below, or let the lower one say in an interface what it needs.';

/** Folders of the frontend, line by line: each imports those of the lines above it, see its README. */
const FRONTEND = [
  ['styles', 'theme', 'patterns', 'connection', 'formats', 'files', 'players', 'pad'],
  ['ui', 'locations'],
  ['page', 'message-form', 'tab-node', 'install', 'asset-sets'],
  ['topics', 'sessions'],
  ['clients', 'devices', 'modules', 'publish', 'calls', 'performance'],
  ['graph', 'joining'],
  ['session-pages', 'learn', 'settings', 'out-of-reach'],
  ['examples', 'party'],
  ['home', 'markers', 'shell'],
];
const inFrontend = (folders) => `^apps/frontend/src/(${folders.join('|')})/`;
const frontendOrder = FRONTEND.flatMap((line, index) =>
  line.map((folder) => ({
    name: `order-of-the-frontend: ${folder}`,
    comment: 'Move what both need up in the list of this file, to a line that both may import.',
    severity: 'error',
    from: { path: inFrontend([folder]) },
    to: {
      path: '^apps/frontend/src/',
      pathNot: inFrontend([folder, ...FRONTEND.slice(0, index).flat()]),
    },
  })),
);

frontendOrder.push({
  name: 'order-of-the-frontend: a folder that is not in the list',
  comment: 'Add it to its line of the list in this file.',
  severity: 'error',
  from: { path: '^apps/frontend/src/[^/]+/', pathNot: inFrontend(FRONTEND.flat()) },
  to: { path: '^apps/frontend/src/' },
});

export default {
  forbidden: [
    { name: 'no-circle', comment, severity: 'error', from: {}, to: { circular: true } },
    {
      name: 'no-folder-circle',
      comment,
      severity: 'error',
      scope: 'folder',
      from: {},
      to: { circular: true },
    },
    ...frontendOrder,
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    // Tests may know everything around what they test.
    exclude: { path: String.raw`\.test\.ts$|/testing/|/dist/` },
    tsPreCompilationDeps: true,
    tsConfig: { fileName: 'tsconfig.base.json' },
    enhancedResolveOptions: { extensions: ['.ts', '.js', '.vue'] },
  },
};
