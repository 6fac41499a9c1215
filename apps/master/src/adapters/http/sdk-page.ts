/** A file of the client library. */
export interface SdkFile {
  readonly name: string;
  readonly about: string;
  readonly sizeBytes: number;
}

/**
 * Page that lists the files of the client library, with one line to install and one to import it.
 *
 * @param origin of the master, as the caller reached it
 */
export function sdkPage(origin: string, files: readonly SdkFile[]): string {
  const base = `${escapeHtml(origin)}/sdk`;
  const archive = files.find(({ name }) => name.endsWith('.tgz'))?.name ?? '';
  const rows = files.map(
    ({ name, about, sizeBytes }) =>
      `<tr><td><a href="/sdk/${name}">${name}</a><td>${about}<td>${Math.ceil(sizeBytes / 1000)} kB`,
  );
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Ubi-Interact: client library</title>
<style>
  :root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
  body { max-width: 44rem; margin: 10vh auto; padding: 0 1.5rem; }
  td { padding: 0.25rem 1.5rem 0.25rem 0; }
  td:last-child { white-space: nowrap; }
  pre { overflow: auto; font: 0.9em ui-monospace, monospace; }
</style>
<h1>Client library</h1>
<p>Programs publish and subscribe with it. It has the version of this master.</p>
<p>In a project for Node 20.19 or newer:</p>
<pre>npm i ${base}/${archive}</pre>
<p>In a page, without a build:</p>
<pre>import { createClient } from '${base}/ubii-client.js';</pre>
<table>
${rows.join('\n')}
</table>
<p>The package has a README with examples. <a href="/learn/own-program">Lesson</a></p>
</html>
`;
}

function escapeHtml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}
