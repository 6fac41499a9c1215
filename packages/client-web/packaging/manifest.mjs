/** Entries of the published package: name of the built file, and its source. */
export const ENTRIES = {
  index: 'src/index.ts',
  node: 'src/node.ts',
  processing: 'src/processing/package.ts',
};

/**
 * The `package.json` of the published package: nothing to install or to resolve, JavaScript with types.
 *
 * @param {Record<string, unknown>} manifest of the workspace package
 */
export function publishedManifest({ name, version, description, license }) {
  const entry = (file) => ({ types: `./${file}.d.ts`, default: `./${file}.js` });
  return {
    name,
    version,
    description,
    license,
    type: 'module',
    engines: { node: '>=20.19' },
    exports: {
      '.': entry('index'),
      './node': entry('node'),
      './processing': entry('processing'),
      './package.json': './package.json',
    },
  };
}
