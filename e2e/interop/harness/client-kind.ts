/** The published clients of the interop test, by the platform they are for. */
export const CLIENT_KINDS = ['nodejs', 'webbrowser', 'python'] as const;

/** One of the published clients. */
export type ClientKind = (typeof CLIENT_KINDS)[number];

/** Package and version, as a test's name shows it. */
export const CLIENT_NAMES: { readonly [K in ClientKind]: string } = {
  nodejs: '@tum-far/ubii-node-nodejs 0.4.2',
  webbrowser: '@tum-far/ubii-node-webbrowser 0.2.6',
  python: 'ubii-node-python 0.3.0',
};
