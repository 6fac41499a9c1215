/** Path in the top bar: a page, and the page above it. */
interface PagePath {
  readonly parent: string | undefined;
  readonly here: string | undefined;
}

/** Returns which parts of the path the heading of the page says: from the part with its name on. */
export function saidByHeading(
  { parent, here }: PagePath,
  heading: string | undefined,
): { readonly parent: boolean; readonly here: boolean } {
  const isParentSaid = heading !== undefined && heading === parent;
  return {
    parent: isParentSaid,
    here: isParentSaid || (heading !== undefined && heading === here),
  };
}
