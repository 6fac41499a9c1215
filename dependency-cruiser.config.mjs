/**
 * No file and no folder imports, by whatever way, what imports it: one can be understood, tested and moved without the
 * other. Types count: who needs a type knows its owner. Where a lower folder needs something of a higher one, it says in
 * an interface of its own what that is.
 */
const comment =
  'Move what both need to a folder below, or let the lower one say in an interface what it needs.';

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
