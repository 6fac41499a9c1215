/** A third-party package, as listed by the build. */
export interface PackageLicence {
  readonly name: string;
  readonly version: string;
  /** SPDX expression. */
  readonly licence: string;
  readonly author: string;
  readonly url: string;
  /** Programs that contain it: `frontend`, `master`, `node`. */
  readonly parts: readonly string[];
  /** Empty when the package has no licence text. */
  readonly text: string;
}

/** Content of `/licences.json`, which the build generates from the bundled packages. */
export interface Licences {
  readonly own: Omit<PackageLicence, 'parts'>;
  readonly packages: readonly PackageLicence[];
}

const FILE = '/licences.json';

/** @throws {Error} with a message when there is no list */
export async function fetchLicences(): Promise<Licences> {
  const response = await fetch(FILE).catch(() => {
    throw new Error('The master does not answer, so the list is not available.');
  });
  if (!response.ok || !(response.headers.get('content-type') ?? '').includes('json')) {
    throw new Error('This frontend is not built. The build creates the list of licences.');
  }
  return (await response.json()) as Licences;
}

/** Packages that match every word of a search in name, licence, author or part. */
export function filterLicences(
  packages: readonly PackageLicence[],
  search: string,
): readonly PackageLicence[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return packages.filter(({ name, version, licence, author, parts }) => {
    const text = `${name} ${version} ${licence} ${author} ${parts.join(' ')}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

/** Number of packages by licence, highest first. */
export function licenceCounts(packages: readonly PackageLicence[]): [string, number][] {
  const counts = new Map<string, number>();
  for (const { licence } of packages) counts.set(licence, (counts.get(licence) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1] || a[0].localeCompare(b[0]));
}
