/** Shown where the frontend should be, when it is not there. */
export const NOT_BUILT_PAGE = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Ubi-Interact: the frontend is not built</title>
<style>
  :root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
  body { max-width: 36rem; margin: 15vh auto; padding: 0 1.5rem; }
  code { font: 0.9em ui-monospace, monospace; }
</style>
<h1>The frontend is not built</h1>
<p>This master runs: services and topic data work. Its pages are missing.</p>
<p>Stop it and run <code>npm start</code>, which builds what is missing. While working on the
frontend, run <code>npm run dev</code> and open the address it prints for pages.</p>
</html>
`;
