import { existsSync, readdirSync } from 'node:fs';

import { inRoot, readJson } from './repository.mjs';

/**
 * Allowed licences of shipped packages.
 *
 * @typedef {object} LicencePolicy
 * @property {string[]} allowed SPDX identifiers
 * @property {Record<string, { licence: string, reason: string }>} exceptions by name: a package with exactly this licence
 */

/**
 * Says which packages have a licence that is not allowed, one sentence each.
 *
 * @param {Iterable<{ name: string, version: string, licence: string | undefined }>} packages
 * @param {LicencePolicy} policy
 * @returns {string[]}
 */
export function licenceProblems(packages, { allowed, exceptions }) {
  const problems = [];
  for (const { name, version, licence } of packages) {
    if (licence !== undefined && licence === exceptions[name]?.licence) continue;
    if (licence !== undefined && isAllowed(licence, allowed)) continue;
    problems.push(
      `${name}@${version} has the licence ${licence ?? 'that is not told'}: allow it in security/policy.json with a reason, or do without it.`,
    );
  }
  return problems;
}

/**
 * Whether an SPDX expression can be met with allowed licences: one side of OR, both of AND.
 *
 * @param {string} expression
 * @param {readonly string[]} allowed
 */
export function isAllowed(expression, allowed) {
  const tokens = expression.match(/\(|\)|[^\s()]+/g) ?? [];
  let at = 0;
  /** @returns {boolean} */
  const term = () => {
    const token = tokens[at++];
    if (token !== '(') return token !== undefined && allowed.includes(token);
    const result = either();
    return tokens[at++] === ')' && result;
  };
  /** @returns {boolean} */
  const both = () => {
    let result = term();
    while (tokens[at] === 'AND') {
      at += 1;
      result = term() && result;
    }
    return result;
  };
  /** @returns {boolean} */
  const either = () => {
    let result = both();
    while (tokens[at] === 'OR') {
      at += 1;
      result = both() || result;
    }
    return result;
  };
  // Remaining words, such as WITH, are not supported
  return either() && at === tokens.length;
}

/**
 * The licence of each installed package, as its manifest tells it.
 *
 * @returns {(key: string) => string | undefined} by `name@version`; undefined when it tells none, or is not installed
 */
export function installedLicences() {
  const store = inRoot('node_modules/.pnpm');
  const folders = new Map();
  for (const folder of existsSync(store) ? readdirSync(store) : []) {
    const [, name, version] = /^(@?[^@]+)@([^_(]+)/.exec(folder) ?? [];
    if (name !== undefined) folders.set(`${name.replace('+', '/')}@${version}`, { folder, name });
  }
  return (key) => {
    const found = folders.get(key);
    if (found === undefined) return undefined;
    const file = inRoot(
      ...['node_modules/.pnpm', found.folder, 'node_modules'],
      ...[found.name.replace('+', '/'), 'package.json'],
    );
    return existsSync(file) ? licenceOf(readJson(file)) : undefined;
  };
}

/** The licence in a manifest; older ones have an object, or a list. */
export function licenceOf({ license, licenses }) {
  if (typeof license === 'string') return license;
  if (typeof license?.type === 'string') return license.type;
  const types = Array.isArray(licenses) ? licenses.map((one) => one.type ?? one) : [];
  return types.length === 0 ? undefined : types.join(' OR ');
}
