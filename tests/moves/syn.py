import json,shlex,subprocess,sys,re
from concurrent.futures import ThreadPoolExecutor
root=sys.argv[1]; pat=sys.argv[2]; jobs=int(sys.argv[3]) if len(sys.argv)>3 else 1
e=json.load(open(f'{root}/build/release/compile_commands.json'))
def go(x):
    w=shlex.split(x['command'])
    while w[0].endswith('ccache'): w=w[1:]
    i=w.index('-o'); w=w[:i]+w[i+2:]
    w=[a for a in w if a not in('-O3','-Winvalid-pch')]+['-fsyntax-only','-fmax-errors=60','-Wno-unused','-w']
    if '-include' in w: i=w.index('-include'); w=w[:i]+w[i+2:]
    r=subprocess.run(w,cwd=x['directory'],capture_output=True,text=True)
    return x['file'],r.stderr
sel=[x for x in e if re.search(pat,x['file'])]
with ThreadPoolExecutor(jobs) as p:
    for f,err in p.map(go,sel):
        lines=[l for l in err.split('\n') if 'error:' in l]
        if lines: print('##',f.replace(root+'/',''),len(lines)); print('\n'.join(l.replace(root+'/','') for l in lines[:8]))
print(len(sel),'checked')
