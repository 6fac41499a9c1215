import semver from 'semver';

/**
 * A package that asks for a later version of Node and is used anyway.
 *
 * @typedef {object} EngineException
 * @property {string} node the range that it asks for: when it asks for another one, it is looked at again
 * @property {string} reason
 */

/**
 * Says which packages do not take the lowest version of Node, and which exceptions are not needed, one sentence each.
 *
 * @param {Iterable<import('./lockfile.mjs').LockedPackage>} packages
 * @param {string} lowest version of Node
 * @param {Record<string, EngineException>} exceptions by name
 * @returns {string[]}
 */
export function engineProblems(packages, lowest, exceptions) {
  const problems = [];
  const needed = new Set();
  for (const { name, version, nodeRange } of packages) {
    // A range that cannot be read admits nothing.
    if (nodeRange === '' || semver.satisfies(lowest, nodeRange)) continue;
    if (exceptions[name]?.node === nodeRange) {
      needed.add(name);
      continue;
    }
    problems.push(
      `${name}@${version} asks for Node ${nodeRange}, and not ${lowest}: take a version that does (overrides in pnpm-workspace.yaml for what others need), or name it in security/policy.json with a reason.`,
    );
  }
  for (const name of Object.keys(exceptions)) {
    if (needed.has(name)) continue;
    problems.push(
      `security/policy.json has an exception for the version of Node that ${name} asks for, which is not locked with this range any more: remove it.`,
    );
  }
  return problems;
}
