import { filesOfSandbox, licencesOf } from '../../../scripts/lib/licences.mjs';

/**
 * Text of the licences of all packages of others in the bundles.
 *
 * @param {readonly string[]} files absolute paths of bundled files; those of the worker of modules are added
 */
export function describeLicences(files) {
  const parts = licencesOf({ client: [...files, ...filesOfSandbox()] }).map(
    ({ name, version, licence, author, url, text }) => {
      const facts = [`${name} ${version}`, licence, author, url].filter((fact) => fact !== '');
      return `${facts.join('\n')}\n\n${text}`.trim();
    },
  );
  return `${parts.join(`\n\n${'-'.repeat(80)}\n\n`)}\n`;
}
