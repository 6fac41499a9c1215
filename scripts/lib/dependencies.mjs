import semver from 'semver';

import { ageOfAdvisories, checkAdvisories } from './advisories.mjs';
import { installedLicences, licenceProblems } from './dependency-licences.mjs';
import { productionPackages, readLock } from './lockfile.mjs';
import { engineProblems } from './node-engines.mjs';
import { inRoot, readJson } from './repository.mjs';

/** The pinned advisories. */
export const advisoryFile = inRoot('security/advisories.json');

/**
 * Compares locked packages with known advisories, allowed licences and the lowest version of Node, without the network.
 *
 * @param {number} nowMs milliseconds since the epoch, for the age of the advisories, which fails nothing
 * @returns {{ problems: string[], notes: string[] }} what fails the gate, and what people should know
 */
export function checkDependencies(nowMs) {
  const lock = readLock();
  const known = readJson(advisoryFile);
  const policy = readJson(inRoot('security/policy.json'));
  const { problems, notes } = checkAdvisories(
    lock.packages.values(),
    known,
    policy.advisoryExceptions,
  );
  const licence = installedLicences();
  const handedOn = [...productionPackages(lock)]
    .map((key) => ({ ...lock.packages.get(key), licence: licence(key) }))
    // Most of those for some systems are not installed here; the package they belong to is.
    .filter(({ isForSomeSystems }) => !isForSomeSystems);
  return {
    problems: [
      ...problems,
      ...licenceProblems(handedOn, policy.licences),
      ...engineProblems(lock.packages.values(), lowestNode(), policy.engineExceptions),
    ],
    notes: [ageOfAdvisories(known, nowMs), ...notes],
  };
}

/** The lowest version of Node that this repository runs on. */
function lowestNode() {
  return semver.minVersion(readJson(inRoot('package.json')).engines.node).version;
}
