/** Titles of the reference pages, for the contents; their texts are loaded on demand. */
export const REFERENCE_TITLES: readonly { readonly id: string; readonly title: string }[] = [
  { id: 'data-formats', title: 'Data formats' },
  { id: 'services', title: 'Services' },
  { id: 'modules', title: 'Modules' },
  { id: 'wire-protocol', title: 'Wire protocol' },
  { id: 'glossary', title: 'Glossary' },
  { id: 'guides', title: 'Guides' },
];
