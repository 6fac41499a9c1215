/** Files that become a recording first. */
export const isForeignFile = ({ name }: { readonly name: string }): boolean =>
  /\.(csv|tsv|txt|xdf)$/i.test(name);

/** What can be opened on the page of recordings. */
export const OPENED_FILES = '.mcap,.csv,.tsv,.xdf';
