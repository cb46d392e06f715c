// proto
#include "bond/build/wall_facets.h"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstdio>
namespace muckpile {
namespace {
struct Place { Vec3 out; double r; double along; };
Place place(const Hole& h, const Vec3& x){ Vec3 d=(h.collar-h.toe).normalized(); Vec3 v=x-h.toe; double al=v.dot(d); v-=al*d; double r=v.norm(); return {r>0?Vec3(v/r):Vec3(Vec3::Zero()),r,al/(h.collar-h.toe).norm()}; }
}
void fit_walls(const std::vector<Block>& blocks, int first_tag, std::span<const Hole> holes, FacetSet& set) {
  const char* e=getenv("WALL_MODE"); int mode=e?atoi(e):1; if(mode==0) return;
  const char* e2=getenv("WALL_DEPTH"); bool depth=e2?atoi(e2):1;
  for(size_t k=0;k<holes.size();++k){ const Hole& hole=holes[k];
    const char* rv=getenv("WALL_RV"); double r1=hole.radius*(rv?atof(rv):1.0);
    std::vector<double> W(blocks.size(),0); std::vector<char> wall(blocks.size(),0);
    for(auto& f:set.faces) if(f.hole==(int)k){ size_t b=f.tag-first_tag; Place p=place(hole,blocks[b].mass.centroid); if(p.along<0||p.along>1||p.r<0.3*r1) continue; wall[b]=1; W[b]+=-f.area*f.normal.dot(p.out)/p.r/(r1*r1);
      if(depth){ Vec3 x=f.start-hole.toe; double a=-f.normal.dot(x); double d=f.normal.dot(f.arm); double D=a+f.normal.dot(p.out)*r1*r1/p.r; f.depth_share=std::clamp(D/d,0.05,1.0); } }
    auto psi=[&](size_t b){Place p=place(hole,blocks[b].mass.centroid); return Vec3(p.out/std::max(p.r,0.3*r1));};
    std::vector<double> out(blocks.size(),0), ww(blocks.size(),0); double tot_out=0,tot_ww=0,totW=0,tot_all=0;
    struct F{size_t f,i,j;double ai,aj,e;}; std::vector<F> fs;
    for(size_t f=0;f<set.facets.size();++f){ auto& t=set.facets[f]; if(t.kind!=FacetKind::joint) continue; size_t i=t.tag_i-first_tag,j=t.tag_j-first_tag; if(!wall[i]&&!wall[j]) continue;
      double h=t.normal.dot(t.arm_i-t.arm_j); Vec3 pi=psi(i),pj=psi(j); Vec3 d=pi-pj; double c=t.area/h; double ai=c*pi.dot(d), aj=-c*pj.dot(d);
      if(wall[i]&&wall[j]) { fs.push_back({f,i,j,ai,aj,c*d.squaredNorm()}); tot_ww+=c*d.squaredNorm(); }
      else { size_t b=wall[i]?i:j; double a=wall[i]?ai:aj; out[b]+=a; tot_out+=a; if(mode==2) { fs.push_back({f,i,j,wall[i]?ai:0,wall[j]?aj:0,c*d.squaredNorm()}); } }
    }
    for(double w:W) totW+=w;
    double kappa=(totW-tot_out)/tot_ww;
    if(mode==2) { kappa=totW/(tot_ww+tot_out); for(auto&x:fs) set.facets[x.f].stiffening=kappa; }
    if(mode==1) for(auto&x:fs) set.facets[x.f].stiffening=kappa;
    if(mode==3){ // least change of weights with each block in radial balance
      std::vector<double> need(blocks.size(),0), den(blocks.size(),0), mu(blocks.size(),0), w(fs.size(),1.0);
      for(int it=0;it<200;++it){ std::vector<double> got(blocks.size(),0); std::fill(den.begin(),den.end(),0.0);
        for(size_t q=0;q<fs.size();++q){auto&x=fs[q]; w[q]=std::clamp(1+(mu[x.i]*x.ai+mu[x.j]*x.aj)/x.e,0.3,4.0); got[x.i]+=w[q]*x.ai; got[x.j]+=w[q]*x.aj; den[x.i]+=x.ai*x.ai/x.e; den[x.j]+=x.aj*x.aj/x.e;}
        for(size_t b=0;b<blocks.size();++b) if(wall[b]&&den[b]>0) mu[b]+=0.5*(W[b]-out[b]-got[b])/den[b]; }
      double lo=9,hi=0; for(size_t q=0;q<fs.size();++q){ set.facets[fs[q].f].stiffening=w[q]; lo=std::min(lo,w[q]);hi=std::max(hi,w[q]);} printf("   w %.2f..%.2f ",lo,hi);
    }
    if(getenv("WALL_PRINT")) printf("   kappa %.3f W %.3f out %.3f ww %.3f\n",kappa,totW,tot_out,tot_ww);
  }
}
}
