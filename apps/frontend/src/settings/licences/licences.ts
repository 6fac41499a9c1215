/** One package of others, as the build lists it. */
export interface PackageLicence {
  readonly name: string;
  readonly version: string;
  /** SPDX expression. */
  readonly licence: string;
  readonly author: string;
  readonly url: string;
  /** `frontend`, `master`, `node`: what has it in it. */
  readonly parts: readonly string[];
  /** Empty when the package brings no text. */
  readonly text: string;
}

/** `/licences.json`, which the build makes from what it bundles. */
export interface Licences {
  readonly own: Omit<PackageLicence, 'parts'>;
  readonly packages: readonly PackageLicence[];
}

const FILE = '/licences.json';

/** @throws Error in words when there is no list */
export async function fetchLicences(): Promise<Licences> {
  const response = await fetch(FILE).catch(() => {
    throw new Error('The master does not answer, so the list is not available.');
  });
  if (!response.ok || !(response.headers.get('content-type') ?? '').includes('json')) {
    throw new Error('This frontend is not built. The build creates the list of licences.');
  }
  return (await response.json()) as Licences;
}

/** Packages with every word of a search in name, licence, author or part. */
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

/** How many packages are under which licence, most first. */
export function licenceCounts(packages: readonly PackageLicence[]): [string, number][] {
  const counts = new Map<string, number>();
  for (const { licence } of packages) counts.set(licence, (counts.get(licence) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1] || a[0].localeCompare(b[0]));
}
