// What a program of whatever user may do: it prints the number of the role.
const response = await fetch(`http://localhost:${process.argv[2]}/services/json`, {
  method: 'POST',
  headers: { 'content-type': 'application/json' },
  body: '{"topic":"/services/ubii/join_check","joinCheckRequest":{}}',
});
const { joinCheck } = await response.json();
const names = ['NONE', 'ADMIN', 'PARTICIPANT', 'PLAYER', 'VIEWER'];
const role = joinCheck?.role ?? 0;
console.log(typeof role === 'number' ? role : names.indexOf(role.replace('ACCESS_ROLE_', '')));
