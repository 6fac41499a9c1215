import semver from 'semver';

/**
 * One known vulnerability, as the registry's bulk endpoint tells it.
 *
 * @typedef {object} Advisory
 * @property {string} id such as `GHSA-…`
 * @property {string} title
 * @property {'low' | 'moderate' | 'high' | 'critical'} severity
 * @property {string} vulnerable_versions range of npm
 * @property {string} url
 */

/**
 * Known advisories of locked packages, with their date. Stored in the repository, so that the gate needs no network.
 *
 * @typedef {object} AdvisoryFile
 * @property {string} updated day, such as `2026-01-31`
 * @property {string} source where it is from
 * @property {Record<string, string[]>} asked versions that were asked for, by name; the others nothing is known of
 * @property {Record<string, Advisory[]>} advisories by name of the package
 */

/**
 * An advisory that does not concern us.
 *
 * @typedef {object} AdvisoryException
 * @property {string} package
 * @property {string} reason
 */

/** Severities that fail the gate. */
const SERIOUS = ['high', 'critical'];

/** From this age on the gate asks for newer advisories, days. */
const OLD_DAYS = 90;

const DAY_MS = 24 * 3_600_000;

/**
 * Compares locked packages with what is known.
 *
 * @param {Iterable<{ name: string, version: string }>} packages
 * @param {AdvisoryFile} file
 * @param {Record<string, AdvisoryException>} exceptions by id of the advisory
 * @returns {{ problems: string[], notes: string[] }} what fails the gate, and what people should know
 */
export function checkAdvisories(packages, { advisories, asked }, exceptions) {
  const problems = [];
  const notes = [];
  const used = new Set();
  const unknown = [];
  for (const { name, version } of packages) {
    if (asked[name]?.includes(version) !== true) unknown.push(`${name}@${version}`);
    for (const advisory of advisories[name] ?? []) {
      if (!isVulnerable(version, advisory)) continue;
      const sentence = `${name}@${version}: ${advisory.title} (${advisory.severity}, ${advisory.url})`;
      const exception = exceptions[advisory.id];
      if (exception?.package === name) {
        used.add(advisory.id);
        notes.push(`${sentence}; does not concern us: ${exception.reason}`);
      } else if (SERIOUS.includes(advisory.severity)) {
        problems.push(
          `${sentence}. Update it, or say in security/policy.json why it does not concern us.`,
        );
      } else notes.push(sentence);
    }
  }
  for (const [id, exception] of Object.entries(exceptions)) {
    if (!used.has(id)) {
      problems.push(
        `security/policy.json has an exception for ${id} of ${exception.package}, which is not locked in a vulnerable version any more: remove it.`,
      );
    }
  }
  if (unknown.length > 0) {
    const names = unknown.length > 5 ? `${unknown.slice(0, 5).join(', ')}, …` : unknown.join(', ');
    notes.push(
      `${unknown.length} locked versions were not asked for (${names}): nothing is known of them beyond what the file has. Run npm run advisories.`,
    );
  }
  return { problems, notes };
}

/** @param {string} version @param {Advisory} advisory */
function isVulnerable(version, { id, vulnerable_versions: range }) {
  if (semver.validRange(range) === null) {
    throw new Error(`security/advisories.json: ${id} has the range "${range}", which is none`);
  }
  return semver.satisfies(version, range, { includePrerelease: true });
}

/**
 * Age of the file, in words.
 *
 * @param {AdvisoryFile} file
 * @param {number} nowMs milliseconds since the epoch
 * @returns {string}
 */
export function ageOfAdvisories({ updated, source }, nowMs) {
  const days = Math.floor((nowMs - Date.parse(updated)) / DAY_MS);
  const age = `advisories of ${updated} (${days} days ago; ${source})`;
  return days > OLD_DAYS ? `${age}. They are old: run npm run advisories.` : age;
}

/**
 * The body for the registry's bulk endpoint, and what the file says was asked for.
 *
 * @param {Iterable<{ name: string, version: string }>} packages
 * @returns {Record<string, string[]>} versions by name, sorted
 */
export function versionsByName(packages) {
  const asked = {};
  for (const { name, version } of packages) (asked[name] ??= []).push(version);
  return Object.fromEntries(
    Object.entries(asked)
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([name, versions]) => [name, versions.sort(semver.compare)]),
  );
}

/**
 * Converts a registry's answer to the format of the file.
 *
 * @param {Record<string, object[]>} answer
 * @returns {Record<string, Advisory[]>}
 */
export function advisoriesFromAnswer(answer) {
  return Object.fromEntries(
    Object.entries(answer)
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([name, list]) => [
        name,
        list.map(({ id, url, title, severity, vulnerable_versions }) => ({
          id: /GHSA-[\w-]+$/.exec(url)?.[0] ?? String(id),
          title,
          severity,
          vulnerable_versions,
          url,
        })),
      ]),
  );
}
