import { productionPackages } from './lockfile.mjs';

/**
 * A bill of materials in the form CycloneDX 1.6: every locked package with its hash, licence and what it
 * needs. The same lockfile gives the same text: it has no time and no number of its own.
 *
 * @param {import('./lockfile.mjs').Lock} lock
 * @param {{ name: string, version: string, license: string, description: string }} own our manifest
 * @param {(key: string) => string | undefined} licenceOf by `name@version`
 */
export function createSbom(lock, own, licenceOf) {
  const production = productionPackages(lock);
  const root = `pkg:npm/${own.name}@${own.version}`;
  const direct = [...lock.importers.values()].flatMap(({ production, development }) => [
    ...production,
    ...development,
  ]);
  return {
    $schema: 'http://cyclonedx.org/schema/bom-1.6.schema.json',
    bomFormat: 'CycloneDX',
    specVersion: '1.6',
    version: 1,
    metadata: {
      component: {
        type: 'application',
        'bom-ref': root,
        name: own.name,
        version: own.version,
        description: own.description,
        licenses: [{ license: { id: own.license } }],
        purl: root,
      },
    },
    components: [...lock.packages].map(([key, entry]) =>
      component(key, entry, production.has(key), licenceOf),
    ),
    dependencies: [
      { ref: root, dependsOn: refsOf(lock, direct) },
      ...[...lock.packages.values()].map((entry) => ({
        ref: packageUrl(entry),
        dependsOn: refsOf(lock, entry.dependencies),
      })),
    ],
  };
}

function component(key, entry, isProduction, licenceOf) {
  const [, group, name] = /^(?:(@[^/]+)\/)?(.*)$/.exec(entry.name);
  // Packages that are not installed on every system have no licence here, so that the text is the same everywhere.
  const licence = entry.isForSomeSystems ? undefined : licenceOf(key);
  const purl = packageUrl(entry);
  return {
    type: 'library',
    'bom-ref': purl,
    ...(group === undefined ? {} : { group }),
    name,
    version: entry.version,
    // CycloneDX: what is not in what people get is `excluded`
    scope: isProduction ? 'required' : 'excluded',
    ...(entry.integrity === '' ? {} : { hashes: [hashOf(entry.integrity)] }),
    ...(licence === undefined ? {} : { licenses: [{ expression: licence }] }),
    purl,
  };
}

/** @param {string} integrity `sha512-<base64>` */
function hashOf(integrity) {
  const [, bits, content] = /^sha(\d+)-(.+)$/.exec(integrity);
  const alg = bits === '1' ? 'SHA-1' : `SHA-${bits}`;
  return { alg, content: Buffer.from(content, 'base64').toString('hex') };
}

/** https://github.com/package-url/purl-spec, type npm: the @ of a scope is written as %40. */
function packageUrl({ name, version }) {
  return `pkg:npm/${name.replace('@', '%40')}@${version.replaceAll('+', '%2B')}`;
}

function refsOf(lock, keys) {
  const refs = keys.map((key) => packageUrl(lock.packages.get(key)));
  return [...new Set(refs)].sort();
}
